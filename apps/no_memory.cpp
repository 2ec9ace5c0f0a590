#include "apps/no_memory.h"

#include <new>

void call_without_memory(void (*end)())
{
    std::set_new_handler(end);
}
