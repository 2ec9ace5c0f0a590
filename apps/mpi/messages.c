#include "apps/mpi/messages.h"

#include <mpi.h>
#include <string.h>

MessageCount message_count;

void message_send(int rank, Message message, const void *data, size_t size)
{
    GP_ASSERT(size <= INT32_MAX);
    message_count.messages++;
    message_count.bytes += size;
    MPI_Send(size ? data : "", (int)size, MPI_BYTE, rank, (int)message, MPI_COMM_WORLD);
}

bool message_look(int *rank, Message *message, size_t *size)
{
    int is_there = 0, bytes = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &is_there, &status);
    if (!is_there)
        return false;
    MPI_Get_count(&status, MPI_BYTE, &bytes);
    *rank = status.MPI_SOURCE;
    *message = (Message)status.MPI_TAG;
    *size = (size_t)bytes;
    return true;
}

void message_take(int rank, Message message, void *data, size_t size)
{
    message_count.messages++;
    message_count.bytes += size;
    MPI_Recv(data, (int)size, MPI_BYTE, rank, (int)message, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
}

/* Before an item's bytes, or the reason why there are none. */
typedef struct DrawnHead {
    uint64_t item, same;
    int64_t result;
} DrawnHead;

void message_send_drawn(Drawn *drawn)
{
    const DrawnHead head = { drawn->item, drawn->same, drawn->result };
    const char *rest = drawn->result ? drawn->error.text : drawn->bytes;
    const size_t size = drawn->result ? strlen(drawn->error.text) : drawn->size;
    GpBytes bytes = { .data = NULL };
    gp_bytes_reserve(&bytes, sizeof head + size);
    gp_bytes_append(&bytes, &head, sizeof head);
    gp_bytes_append(&bytes, rest ? rest : "", size);
    if (bytes.failed || bytes.size > INT32_MAX) {
        const DrawnHead failed = { drawn->item, 0, GP_ERROR_MEMORY };
        message_send(0, MESSAGE_DRAWN, &failed, sizeof failed);
    } else {
        message_send(0, MESSAGE_DRAWN, bytes.data, bytes.size);
    }
    gp_free(bytes.data);
    gp_free(drawn->bytes);
    drawn->bytes = NULL;
}

bool message_read_drawn(const char *data, size_t size, Drawn *drawn)
{
    DrawnHead head;
    GP_ASSERT(size >= sizeof head);
    memcpy(&head, data, sizeof head);
    size -= sizeof head;
    *drawn =
        (Drawn){ .item = (uint32_t)head.item, .result = (GpResult)head.result, .same = head.same };
    if (drawn->result) {
        const size_t length = size < sizeof drawn->error.text ? size : sizeof drawn->error.text - 1;
        memcpy(drawn->error.text, data + sizeof head, length);
        drawn->error.text[length] = '\0';
        return true;
    }
    drawn->size = size;
    drawn->bytes = gp_alloc_unset(size + 1);
    if (drawn->bytes)
        memcpy(drawn->bytes, data + sizeof head, size);
    return drawn->bytes != NULL;
}
