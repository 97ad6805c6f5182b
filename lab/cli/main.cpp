#include "lab/cli/program.hpp"
#include "lab/session/run_job.hpp"
#ifdef GLINT_VIEWER
#include "lab/view/view_command.hpp"
#endif

int main(int argc, char** argv) {
    glint::cli::AddCommand view;
#ifdef GLINT_VIEWER
    view = glint::view::addViewCommand;
#endif
    return glint::cli::runProgram(
        argc, argv, [](const glint::render::RenderJob& job) { return glint::render::runJob(job); }, view);
}
