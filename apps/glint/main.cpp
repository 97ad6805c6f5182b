#include "program.hpp"
#include "render/run_job.hpp"

int main(int argc, char** argv) {
    return glint::cli::runProgram(argc, argv,
                                  [](const glint::render::RenderJob& job) { return glint::render::runJob(job); });
}
