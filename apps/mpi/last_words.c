#include "apps/mpi/last_words.h"

#include "apps/items/items.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static int own_rank, rank_count;
static const Host *hosts;
static char (*at)[ITEM_NAME]; /* of each rank */

void last_words_begin(int rank, int count, const Host *all)
{
    own_rank = rank;
    rank_count = count;
    hosts = all;
    at = gp_alloc((size_t)count, ITEM_NAME);
}

void last_words_set(int rank, const char *item)
{
    if (at)
        snprintf(at[rank], ITEM_NAME, "%s", item);
}

/* --- in the handler --------------------------------------------------------------------------- */

static bool is_here(int rank)
{
    return strcmp(hosts[rank].name, hosts[own_rank].name) == 0;
}

/* Whoever started it has noticed, and it is no process any more. */
static bool is_gone(int rank)
{
    return is_here(rank) && kill((pid_t)hosts[rank].pid, 0) != 0 && errno == ESRCH;
}

static size_t add(char line[1024], size_t used, const char *text)
{
    const size_t length = strlen(text), room = 1023 - used;
    const size_t part = length < room ? length : room;
    memcpy(line + used, text, part);
    return used + part;
}

static size_t add_number(char line[1024], size_t used, int number)
{
    char digits[12];
    int first = (int)sizeof digits - 1;
    digits[first] = '\0';
    do
        digits[--first] = (char)('0' + number % 10);
    while (number /= 10);
    return add(line, used, digits + first);
}

static size_t add_rank(char line[1024], size_t used, int rank)
{
    used = add(line, used, "rank ");
    used = add_number(line, used, rank);
    used = add(line, used, " on ");
    used = add(line, used, hosts[rank].name);
    if (at && at[rank][0]) {
        used = add(line, used, " (");
        used = add(line, used, at[rank]);
        used = add(line, used, ")");
    }
    return used;
}

static void wait_ms(int ms)
{
    nanosleep(&(struct timespec){ .tv_nsec = ms * 1000000L }, NULL);
}

/* mpirun may notice by its connection: one who dies closes that first, and is a process a little
 * longer. */
static int find_gone(void)
{
    for (int look = 0; look < 20; look++) {
        for (int rank = 0; rank < rank_count; rank++)
            if (rank != own_rank && is_gone(rank))
                return rank;
        wait_ms(10);
    }
    return -1;
}

/* Where all that can be asked are there, those that cannot. */
static size_t add_suspects(char line[1024], size_t used)
{
    int named = 0;
    for (int rank = 1; rank < rank_count; rank++)
        if (!is_here(rank) && named++ < 4) {
            used = add(line, used, named > 1 ? ", " : " with ");
            used = add_rank(line, used, rank);
        }
    return used;
}

void last_words_say(int number)
{
    char line[1024];
    const int gone = find_gone();
    if (own_rank != 0 &&
        !(gone == 0 && own_rank == 1)) /* rank 0 speaks; of its own end the next one */
        return;
    size_t used = add(line, 0, "glasspipe: ");
    if (gone >= 0) {
        used = add_rank(line, used, gone);
        used = add(line, used, gone ? " ended" : ", which writes, ended");
    } else {
        used = add(line, used, "ended by signal ");
        used = add_number(line, used, number);
        used = add_suspects(line, used);
    }
    used = add(line, used, "; --resume goes on from what is done\n");
    (void)!write(STDERR_FILENO, line, used);
    /* mpirun gives on what it reads, and may not look again at one who is gone; busy processors let
     * it wait. After a second it ends whoever is left. */
    wait_ms(500);
}
