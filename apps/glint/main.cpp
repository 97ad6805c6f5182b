#include "program.hpp"

int main(int argc, char** argv) {
    return glint::cli::runProgram(argc, argv, {});
}
