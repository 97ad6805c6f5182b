# cmake -DOUTPUT=costs.cpp -DINPUT=costs.json -DHEADER=lab/tune/cost_table.hpp -DFUNCTION=glint::tune::embeddedCosts
#     -P embed_text.cmake
# Makes the function, declared in HEADER, that returns the file's text.
file(READ ${INPUT} text)
get_filename_component(name ${INPUT} NAME)
file(WRITE ${OUTPUT} "// Made by cmake/embed_text.cmake from ${name}.
#include \"${HEADER}\"

std::string_view ${FUNCTION}() { return R\"text(${text})text\"; }
")
