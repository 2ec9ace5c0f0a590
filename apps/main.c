/* The program `glasspipe`: runs the subcommand and makes sure that its output arrived. */
#include "apps/program.h"

int main(int argc, char **argv)
{
    program_begin();
    return program_run(argc, argv);
}
