/* What ranks tell each other. Rank 0 speaks to the others, and they to rank 0. */
#ifndef APPS_MPI_MESSAGES_H
#define APPS_MPI_MESSAGES_H

#include "apps/items/drawers.h"

#include <stdbool.h>

typedef enum Message {
    MESSAGE_START = 1, /* to a rank: run the command, as far as its items */
    MESSAGE_GIVE,      /* to a rank: uint32_t, an item to draw */
    MESSAGE_STOP,      /* to a rank: there is no more */
    MESSAGE_READY,     /* to rank 0: uint32_t, items that the rank draws at once */
    MESSAGE_DRAWN,     /* to rank 0: an item, by message_send_drawn */
    MESSAGE_FAILED,    /* to rank 0: int32_t, an exit code, and the line that says why */
} Message;

/* Messages that this rank has sent and taken, and their bytes. */
typedef struct MessageCount {
    unsigned long long messages, bytes;
} MessageCount;
extern MessageCount message_count;

void message_send(int rank, Message message, const void *data, size_t size);

/* Whether a message has come, and of what size. */
bool message_look(int *rank, Message *message, size_t *size);

/* The message that was looked at. data: as large */
void message_take(int rank, Message message, void *data, size_t size);

/* Sends an item, and frees its bytes. */
void message_send_drawn(Drawn *drawn);

/* What it was sent as. out: drawn: bytes are the caller's; false: no memory */
bool message_read_drawn(const char *data, size_t size, Drawn *drawn);

#endif
