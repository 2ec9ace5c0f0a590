#define _GNU_SOURCE /* dl_iterate_phdr */
#include "apps/base/content.h"

#include "pipeline/io/file.h"

#include <jansson.h>
#include <limits.h>
#include <link.h>
#include <string.h>
#include <xxhash.h>

enum { MOST_DEPTH = 16 }; /* of JSON, and of files that name each other */

uint64_t content_hash_bytes(const void *bytes, size_t size, uint64_t seed)
{
    return XXH3_64bits_withSeed(bytes, size, seed);
}

/* --- inputs ----------------------------------------------------------------------------------- */

/* in named_by: the file that has the name; NULL: none, and what is no file counts by its name */
static uint64_t hash_name(const char *named_by, const char *name, int depth, uint64_t seed);

static uint64_t hash_texts(const char *file, const json_t *value, int depth, uint64_t seed)
{
    const char *key;
    json_t *member;
    size_t i;
    if (depth == MOST_DEPTH)
        return seed;
    if (json_is_string(value))
        return hash_name(file, json_string_value(value), depth + 1, seed);
    json_array_foreach(value, i, member) seed = hash_texts(file, member, depth + 1, seed);
    json_object_foreach((json_t *)value, key, member) seed =
        hash_texts(file, member, depth + 1, seed);
    return seed;
}

static uint64_t hash_name(const char *named_by, const char *name, int depth, uint64_t seed)
{
    char path[PATH_MAX], extension[8];
    GpFile file;
    if (gp_data_find_beside(named_by, name, path, sizeof path, NULL) ||
        gp_file_read(path, &file, NULL))
        return named_by ? seed : content_hash_bytes(name, strlen(name), seed);
    seed = content_hash_bytes(file.data, file.size, seed);
    gp_file_extension(path, extension);
    json_t *root =
        strcmp(extension, "json") == 0 ? json_loadb(file.data, file.size, 0, NULL) : NULL;
    seed = hash_texts(path, root, depth, seed);
    json_decref(root);
    gp_file_free(&file);
    return seed;
}

uint64_t content_hash(const char *name, uint64_t seed)
{
    return hash_name(NULL, name, 0, seed);
}

/* --- the program ------------------------------------------------------------------------------ */

typedef struct OwnCode {
    ElfW(Addr) inside; /* an address of it */
    uint64_t hash;
} OwnCode;

/* Copies bytes by loads that a sanitizer does not watch: its guards lie between a module's constants. */
__attribute__((no_sanitize("address"))) static void
copy_unwatched(uint8_t *to, const volatile uint8_t *from, size_t size)
{
    for (size_t i = 0; i < size; i++)
        to[i] = from[i];
}

static uint64_t hash_part(ElfW(Addr) begin, size_t size, uint64_t seed)
{
    uint8_t page[4096];
    for (size_t at = 0; at < size; at += sizeof page) {
        const size_t count = size - at < sizeof page ? size - at : sizeof page;
        copy_unwatched(page, (const volatile uint8_t *)(begin + at), count);
        seed = content_hash_bytes(page, count, seed);
    }
    return seed;
}

/* Of the module that has the address, what is loaded and never written to. */
static int hash_module(struct dl_phdr_info *module, size_t size, void *context)
{
    OwnCode *own = context;
    bool is_own = false;
    (void)size;
    for (int i = 0; i < module->dlpi_phnum; i++) {
        const ElfW(Phdr) *part = &module->dlpi_phdr[i];
        const ElfW(Addr) begin = module->dlpi_addr + part->p_vaddr;
        is_own |=
            part->p_type == PT_LOAD && own->inside >= begin && own->inside < begin + part->p_memsz;
    }
    for (int i = 0; i < module->dlpi_phnum && is_own; i++) {
        const ElfW(Phdr) *part = &module->dlpi_phdr[i];
        if (part->p_type == PT_LOAD && (part->p_flags & PF_R) && !(part->p_flags & PF_W))
            own->hash = hash_part(module->dlpi_addr + part->p_vaddr, part->p_filesz, own->hash);
    }
    return is_own;
}

uint64_t content_hash_program(void)
{
    OwnCode own = { .inside = (ElfW(Addr))(uintptr_t)&content_hash_program };
    dl_iterate_phdr(hash_module, &own);
    return own.hash;
}
