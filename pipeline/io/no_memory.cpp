#include "pipeline/io/no_memory.h"

#include <new>

void gp_call_without_memory(void (*end)())
{
    std::set_new_handler(end);
}
