/* The program `glasspipe-mpi`: the commands of `glasspipe`, their work drawn by all ranks of an MPI
 * run.
 *
 * Rank 0 runs the command. Where that comes to work that can be split (apps/items), the other ranks
 * run it too, as far as there, so that all have read the same scene; then they draw what they are
 * given, and rank 0 takes what they send. Of other commands they hear nothing.
 */
#include "apps/program.h"
#include "apps/mpi/ranks.h"

int main(int argc, char **argv)
{
    program_begin();
    const int code = ranks_begin(&argc, &argv);
    if (code)
        return code;
    return ranks_wait_for_work() ? program_run(argc, argv) : 0;
}
