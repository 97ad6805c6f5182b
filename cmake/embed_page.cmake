# cmake -DOUTPUT=page.cpp -DFUNCTION=pageParts -DPAGE=page.html "-DSTYLES=a.css;b.css" "-DSCRIPTS=a.js;b.js" -P embed_page.cmake
# Puts styles and scripts into the page at @STYLE@ and @SCRIPT@, and parts it at @TITLE@ and @DATA@.
set(style "")
foreach(file ${STYLES})
    file(READ ${file} text)
    string(APPEND style "${text}")
endforeach()
set(script "")
foreach(file ${SCRIPTS})
    file(READ ${file} text)
    string(APPEND script "${text}")
endforeach()
file(READ ${PAGE} page)

# At a semicolon CMake would part a list, and an unmatched bracket would join its elements: both are kept out of lists by
# cutting at the markers alone.
set(parts "")
function(add_text text)
    # Some compilers limit a literal: pieces, which the compiler joins.
    set(literal "")
    string(LENGTH "${text}" length)
    set(at 0)
    while(at LESS length)
        string(SUBSTRING "${text}" ${at} 8000 piece)
        string(APPEND literal "\n        R\"glint(${piece})glint\"")
        math(EXPR at "${at} + 8000")
    endwhile()
    string(APPEND parts "    {PagePart::Kind::Text,${literal}},\n")
    set(parts "${parts}" PARENT_SCOPE)
endfunction()
set(rest "${page}")
foreach(marker TITLE STYLE DATA SCRIPT)
    string(FIND "${rest}" "@${marker}@" at)
    if(at LESS 0)
        message(FATAL_ERROR "${PAGE}: @${marker}@ is missing, or not in the order TITLE, STYLE, DATA, SCRIPT")
    endif()
    string(SUBSTRING "${rest}" 0 ${at} before)
    string(LENGTH "@${marker}@" length)
    math(EXPR at "${at} + ${length}")
    string(SUBSTRING "${rest}" ${at} -1 rest)
    add_text("${before}")
    if(marker STREQUAL TITLE)
        string(APPEND parts "    {PagePart::Kind::Title, {}},\n")
    elseif(marker STREQUAL DATA)
        string(APPEND parts "    {PagePart::Kind::Data, {}},\n")
    elseif(marker STREQUAL STYLE)
        add_text("${style}")
    else()
        add_text("${script}")
    endif()
endforeach()
add_text("${rest}")
file(WRITE ${OUTPUT} "// Made by cmake/embed_page.cmake from lab/cli/report/page.
#include \"lab/cli/report/page_template.hpp\"

namespace glint::cli {

static constexpr PagePart k${FUNCTION}[] = {
${parts}};

std::span<const PagePart> ${FUNCTION}() { return k${FUNCTION}; }

} // namespace glint::cli
")
