#include "apps/mpi/ranks.h"

#include "apps/base/machine.h"
#include "apps/commands/options.h"
#include "apps/program.h"
#include "apps/mpi/hosts.h"
#include "apps/mpi/runner.h"
#include "apps/mpi/self_test.h"

#include <fcntl.h>
#include <mpi.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int own_rank, rank_count;
static volatile sig_atomic_t left; /* no rank has anything to say any more */

/* --- joining and leaving ---------------------------------------------------------------------- */

/* At exit, from wherever: rank 0 lets the others go, and all leave together. The first whose code
 * is not 0 makes mpirun end those that are still at it, so all have to know before that nobody is
 * missing. */
static void leave(void)
{
    if (own_rank == 0)
        runner_dismiss();
    else
        runner_say_failure();
    MPI_Barrier(MPI_COMM_WORLD);
    left = 1;
    MPI_Barrier(MPI_COMM_WORLD);
    MPI_Finalize();
}

static void say_last_words(int number)
{
    if (!left)
        runner_say_last_words(number);
}

/* Threads that a rank should draw by: those of its processors that no other rank on its host
 * has. */
static uint32_t threads_here(int ranks_on_host)
{
    const int bound = machine_processors();
    const int all = (int)sysconf(_SC_NPROCESSORS_ONLN);
    const int share = all / ranks_on_host > 1 ? all / ranks_on_host : 1;
    return (uint32_t)(bound < share ? bound : share);
}

static Host describe_self(void)
{
    MPI_Comm here;
    int ranks_on_host = 1, length = 0;
    char name[MPI_MAX_PROCESSOR_NAME] = "";
    Host host = { .pid = (int64_t)getpid(), .test = self_test_hash() };
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
    MPI_Comm_size(here, &ranks_on_host);
    MPI_Comm_free(&here);
    MPI_Get_processor_name(name, &length);
    snprintf(host.name, sizeof host.name, "%.63s", name);
    snprintf(host.version, sizeof host.version, "%s", GP_VERSION);
    host.threads = threads_here(ranks_on_host);
    return host;
}

/* The first rank that is not as rank 0 is; returns an exit code. */
static int compare_ranks(const Host *hosts)
{
    for (int rank = 0; rank < rank_count; rank++) {
        const Host *own = &hosts[0], *other = &hosts[rank];
        if (strcmp(own->version, other->version) != 0)
            return report(EXIT_DIFFERS, "rank %d on %s has version %s, rank 0 on %s %s", rank,
                          other->name, other->version, own->name, own->version);
        if (!other->test || own->test != other->test)
            return report(EXIT_DIFFERS,
                          "rank %d on %s draws the test otherwise (%016llx) than rank 0 on %s "
                          "(%016llx): faulty memory, or another build",
                          rank, other->name, (unsigned long long)other->test, own->name,
                          (unsigned long long)own->test);
    }
    return EXIT_DONE;
}

int ranks_begin(int *argc, char ***argv)
{
    int provided;
    MPI_Init_thread(argc, argv, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &own_rank);
    MPI_Comm_size(MPI_COMM_WORLD, &rank_count);
    const Host self = describe_self();
    Host *hosts = gp_alloc((size_t)rank_count, sizeof *hosts);
    if (!hosts)
        MPI_Abort(MPI_COMM_WORLD, EXIT_INTERNAL);
    MPI_Allgather(&self, sizeof self, MPI_BYTE, hosts, sizeof self, MPI_BYTE, MPI_COMM_WORLD);
    runner_begin(own_rank, rank_count, hosts);
    atexit(leave);
    if (rank_count > 1)
        program_set_last_words(say_last_words);
    return own_rank == 0 ? compare_ranks(hosts) : EXIT_DONE;
}

/* --- ranks other than 0 ----------------------------------------------------------------------- */

/* Results are rank 0's to tell. */
static void be_silent(void)
{
    const int nowhere = open("/dev/null", O_WRONLY);
    if (nowhere >= 0)
        dup2(nowhere, STDOUT_FILENO);
    report_to(runner_note_failure);
}

int ranks_wait_for_work(void)
{
    if (own_rank == 0)
        return 1;
    be_silent();
    return runner_wait_for_start();
}
