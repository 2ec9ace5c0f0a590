#define _GNU_SOURCE /* dl_iterate_phdr */
#include "apps/base/content.h"

#include "pipeline/io/file.h"

#include <jansson.h>
#include <limits.h>
#include <link.h>
#include <string.h>
#include <xxhash.h>

enum { MOST_DEPTH = 16, MOST_FILES = 256 }; /* of JSON, and of files that name each other */

uint64_t content_hash_bytes(const void *bytes, size_t size, uint64_t seed)
{
    return XXH3_64bits_withSeed(bytes, size, seed);
}

/* --- inputs ----------------------------------------------------------------------------------- */

/* Files read so far, by the hash of their path: one that is named again counts by its number, so
 * that files which name each other, and themselves, many times are read once. */
typedef struct Files {
    uint64_t path[MOST_FILES];
    uint32_t count;
    uint64_t hash; /* of all that was read */
} Files;

static void add(Files *files, const void *bytes, size_t size)
{
    files->hash = content_hash_bytes(bytes, size, files->hash);
}

/* Whether a file was not read yet, and there is room for it. */
static bool is_new(Files *files, const char *path)
{
    const uint64_t own = content_hash_bytes(path, strlen(path), 0);
    uint32_t number = 0;
    while (number < files->count && files->path[number] != own)
        number++;
    add(files, &number, sizeof number);
    if (number < files->count || number == MOST_FILES)
        return false;
    files->path[files->count++] = own;
    return true;
}

/* in named_by: the file that has the name; NULL: none, and what is no file counts by its name */
static void add_name(Files *files, const char *named_by, const char *name, int depth);

static void add_texts(Files *files, const char *file, const json_t *value, int depth)
{
    const char *key;
    json_t *member;
    size_t i;
    if (depth == MOST_DEPTH)
        return;
    if (json_is_string(value))
        add_name(files, file, json_string_value(value), depth + 1);
    json_array_foreach(value, i, member) add_texts(files, file, member, depth + 1);
    json_object_foreach((json_t *)value, key, member) add_texts(files, file, member, depth + 1);
}

static void add_name(Files *files, const char *named_by, const char *name, int depth)
{
    char path[PATH_MAX];
    GpFile file;
    if (gp_data_find_beside(named_by, name, path, sizeof path, NULL)) {
        if (!named_by)
            add(files, name, strlen(name));
        return;
    }
    if (!is_new(files, path) || gp_file_read(path, &file, NULL))
        return;
    add(files, file.data, file.size);
    json_t *root =
        gp_file_has_extension(path, "json") ? json_loadb(file.data, file.size, 0, NULL) : NULL;
    add_texts(files, path, root, depth);
    json_decref(root);
    gp_file_free(&file);
}

uint64_t content_hash(const char *name, uint64_t seed)
{
    Files files = { .hash = seed };
    add_name(&files, NULL, name, 0);
    return files.hash;
}

/* --- the program ------------------------------------------------------------------------------ */

typedef struct OwnCode {
    ElfW(Addr) inside; /* an address of it */
    uint64_t hash;
} OwnCode;

/* Copies bytes by loads that a sanitizer does not watch: its guards lie between a module's
 * constants. */
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
