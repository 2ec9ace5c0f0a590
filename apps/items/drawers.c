#include "apps/items/drawers.h"

#include <errno.h>
#include <pthread.h>
#include <time.h>

typedef enum DrawerState { IDLE, DRAWING, FINISHED, ENDED } DrawerState;

typedef struct Drawer {
    struct Drawers *drawers;
    int number;
    pthread_t thread;
    bool started;
    ItemTools tools;
    DrawerState state;
    Drawn drawn;
} Drawer;

struct Drawers {
    const ItemWork *work;
    Drawer *drawer;
    uint32_t count;
    bool stop;
    pthread_mutex_t mutex;
    pthread_cond_t given, finished;
    Drawers *next_left; /* as drawers_stop has it */
};

static void draw(Drawer *drawer)
{
    const ItemWork *work = drawer->drawers->work;
    Drawn *drawn = &drawer->drawn;
    GpBytes bytes = { .data = NULL };
    size_t same = SIZE_MAX;
    drawn->error.text[0] = '\0';
    drawn->result =
        work->draw(work->context, drawn->item, &drawer->tools, &bytes, &same, &drawn->error);
    if (!drawn->result && bytes.failed)
        drawn->result = gp_fail(&drawn->error, GP_ERROR_MEMORY, "out of memory");
    drawn->drawer = drawer->number;
    drawn->bytes = bytes.data;
    drawn->size = bytes.size;
    drawn->same = same < bytes.size ? same : bytes.size;
}

static void *work_on(void *argument)
{
    Drawer *drawer = argument;
    Drawers *drawers = drawer->drawers;
    pthread_mutex_lock(&drawers->mutex);
    for (;;) {
        while (drawer->state != DRAWING && !drawers->stop)
            pthread_cond_wait(&drawers->given, &drawers->mutex);
        if (drawers->stop)
            break;
        pthread_mutex_unlock(&drawers->mutex);
        draw(drawer);
        pthread_mutex_lock(&drawers->mutex);
        drawer->state = FINISHED;
        pthread_cond_signal(&drawers->finished);
    }
    drawer->state = ENDED;
    pthread_mutex_unlock(&drawers->mutex);
    return NULL;
}

static GpResult start_drawer(Drawers *drawers, uint32_t number, const GpDeviceDesc *device,
                             uint32_t threads, GpError *error)
{
    Drawer *drawer = &drawers->drawer[number];
    GpDeviceDesc own = *device;
    own.threads = (int)threads;
    drawer->drawers = drawers;
    drawer->number = (int)number;
    GpResult result = gp_device_create(&own, &drawer->tools.device, error);
    if (!result)
        result = gp_pool_create((int)threads, &drawer->tools.pool, error);
    if (!result && pthread_create(&drawer->thread, NULL, work_on, drawer) != 0)
        result = gp_fail(error, GP_ERROR_MEMORY, "no memory for a thread to draw with");
    drawer->started = !result;
    return result;
}

ItemsCode drawers_start(const ItemWork *work, const GpDeviceDesc *device, uint32_t count,
                        uint32_t least, uint32_t threads_each, Drawers **drawers, GpError *error)
{
    Drawers *made = gp_alloc(1, sizeof *made);
    Drawer *all = gp_alloc(count + 1, sizeof *all);
    if (!made || !all) {
        gp_free(made);
        gp_free(all);
        return items_code(gp_fail(error, GP_ERROR_MEMORY, "out of memory"));
    }
    made->work = work;
    made->drawer = all;
    made->count = count;
    pthread_mutex_init(&made->mutex, NULL);
    pthread_cond_init(&made->given, NULL);
    pthread_cond_init(&made->finished, NULL);
    *drawers = made;
    GpResult result = GP_OK;
    for (uint32_t i = 0; i < count && !result; i++) {
        result = start_drawer(made, i, device, threads_each, error);
        if (result && i >= least) { /* those that there are do it */
            made->count = i + 1;
            result = GP_OK;
            break;
        }
    }
    if (result)
        drawers_stop(drawers, true);
    return result == GP_ERROR_INVALID ? ITEMS_USAGE : items_code(result);
}

static void free_drawer(Drawer *drawer)
{
    gp_device_destroy(&drawer->tools.device);
    gp_pool_destroy(&drawer->tools.pool);
    gp_free(drawer->drawn.bytes);
}

void drawers_stop(Drawers **drawers, bool wait)
{
    Drawers *all = *drawers;
    bool at_work = false;
    *drawers = NULL;
    if (!all)
        return;
    pthread_mutex_lock(&all->mutex);
    all->stop = true;
    pthread_cond_broadcast(&all->given);
    for (uint32_t i = 0; i < all->count; i++)
        at_work = at_work || all->drawer[i].state == DRAWING;
    pthread_mutex_unlock(&all->mutex);
    if (at_work && !wait) {
        static Drawers *left; /* to whoever draws, until the program ends */
        all->next_left = left;
        left = all;
        for (uint32_t i = 0; i < all->count; i++)
            if (all->drawer[i].started)
                pthread_detach(all->drawer[i].thread);
        return;
    }
    for (uint32_t i = 0; i < all->count; i++)
        if (all->drawer[i].started)
            pthread_join(all->drawer[i].thread, NULL);
    for (uint32_t i = 0; i < all->count; i++)
        free_drawer(&all->drawer[i]);
    pthread_cond_destroy(&all->given);
    pthread_cond_destroy(&all->finished);
    pthread_mutex_destroy(&all->mutex);
    gp_free(all->drawer);
    gp_free(all);
}

int drawers_find_free(Drawers *drawers, int from)
{
    int found = -1; /* only the thread that asks makes it anything else */
    pthread_mutex_lock(&drawers->mutex);
    for (uint32_t i = (uint32_t)from; i < drawers->count && found < 0; i++)
        if (drawers->drawer[i].started && drawers->drawer[i].state == IDLE)
            found = (int)i;
    pthread_mutex_unlock(&drawers->mutex);
    return found;
}

void drawers_give(Drawers *drawers, int number, uint32_t item)
{
    Drawer *drawer = &drawers->drawer[number];
    pthread_mutex_lock(&drawers->mutex);
    drawer->drawn = (Drawn){ .item = item };
    drawer->state = DRAWING;
    pthread_cond_broadcast(&drawers->given);
    pthread_mutex_unlock(&drawers->mutex);
}

static Drawer *find_finished(const Drawers *drawers)
{
    for (uint32_t i = 0; i < drawers->count; i++)
        if (drawers->drawer[i].state == FINISHED)
            return &drawers->drawer[i];
    return NULL;
}

bool drawers_wait(Drawers *drawers, double seconds, Drawn *drawn)
{
    struct timespec until;
    clock_gettime(CLOCK_REALTIME, &until);
    const long long ns = until.tv_nsec + (long long)(seconds * 1e9);
    until.tv_sec += (time_t)(ns / 1000000000);
    until.tv_nsec = (long)(ns % 1000000000);
    pthread_mutex_lock(&drawers->mutex);
    Drawer *found = find_finished(drawers);
    while (!found && seconds > 0 &&
           pthread_cond_timedwait(&drawers->finished, &drawers->mutex, &until) != ETIMEDOUT)
        found = find_finished(drawers);
    if (found) {
        *drawn = found->drawn;
        found->drawn.bytes = NULL;
        found->state = IDLE;
    }
    pthread_mutex_unlock(&drawers->mutex);
    return found != NULL;
}
