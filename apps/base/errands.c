#include "apps/base/errands.h"

#include "pipeline/base/base.h"

#include <pthread.h>

enum { WAITING = 8 }; /* errands, at most */

typedef struct Errand {
    ErrandFn *run;
    void *context;
} Errand;

struct Errands {
    pthread_t thread;
    pthread_mutex_t mutex;
    pthread_cond_t given, begun, done;
    Errand waiting[WAITING]; /* a ring: from `first` on, `count` */
    uint32_t first, count;
    bool at_work, stop;
};

static void run_first(Errands *errands)
{
    const Errand errand = errands->waiting[errands->first];
    errands->first = (errands->first + 1) % WAITING;
    errands->count--;
    errands->at_work = true;
    pthread_cond_signal(&errands->begun);
    pthread_mutex_unlock(&errands->mutex);
    errand.run(errand.context);
    pthread_mutex_lock(&errands->mutex);
    errands->at_work = false;
}

static void *work(void *argument)
{
    Errands *errands = argument;
    pthread_mutex_lock(&errands->mutex);
    while (!errands->stop || errands->count) {
        if (errands->count) {
            run_first(errands);
            continue;
        }
        pthread_cond_signal(&errands->done);
        pthread_cond_wait(&errands->given, &errands->mutex);
    }
    pthread_mutex_unlock(&errands->mutex);
    return NULL;
}

static void free_errands(Errands *errands)
{
    pthread_cond_destroy(&errands->given);
    pthread_cond_destroy(&errands->begun);
    pthread_cond_destroy(&errands->done);
    pthread_mutex_destroy(&errands->mutex);
    gp_free(errands);
}

Errands *errands_begin(void)
{
    Errands *errands = gp_alloc(1, sizeof *errands);
    if (!errands)
        return NULL;
    pthread_mutex_init(&errands->mutex, NULL);
    pthread_cond_init(&errands->given, NULL);
    pthread_cond_init(&errands->begun, NULL);
    pthread_cond_init(&errands->done, NULL);
    if (pthread_create(&errands->thread, NULL, work, errands) != 0) {
        free_errands(errands);
        return NULL;
    }
    return errands;
}

void errands_give(Errands *errands, ErrandFn *errand, void *context)
{
    if (!errands) {
        errand(context);
        return;
    }
    pthread_mutex_lock(&errands->mutex);
    while (errands->count == WAITING)
        pthread_cond_wait(&errands->begun, &errands->mutex);
    errands->waiting[(errands->first + errands->count++) % WAITING] = (Errand){ errand, context };
    pthread_cond_signal(&errands->given);
    pthread_mutex_unlock(&errands->mutex);
}

void errands_wait(Errands *errands)
{
    if (!errands)
        return;
    pthread_mutex_lock(&errands->mutex);
    while (errands->count || errands->at_work)
        pthread_cond_wait(&errands->done, &errands->mutex);
    pthread_mutex_unlock(&errands->mutex);
}

void errands_end(Errands **errands)
{
    if (!*errands)
        return;
    pthread_mutex_lock(&(*errands)->mutex);
    (*errands)->stop = true;
    pthread_cond_signal(&(*errands)->given);
    pthread_mutex_unlock(&(*errands)->mutex);
    pthread_join((*errands)->thread, NULL);
    free_errands(*errands);
    *errands = NULL;
}
