#include "apps/points/cache.h"

#include "apps/base/content.h"

#include <string.h>

_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "caches are little-endian");

enum {
    VERSION = 2, /* one more whenever what is built, or how it is kept, changes */
    ALIGNMENT = 64,
    SECTIONS = 7
};

enum { HOLDS_SURFELS = 1, HOLDS_WORDS = 2, HOLDS_COLORS = 4 };

static const char magic[8] = { 'g', 'p', 'p', 'o', 'i', 'n', 't', 's' };

typedef struct Head {
    char magic[8];
    uint32_t version;
    uint32_t struct_bytes; /* of patches, levels and frames, as a check of the version */
    uint64_t key;
    uint64_t size; /* of the file */
    uint64_t hash; /* of the head with 0 here, then of all behind it */
    uint32_t surfel_count, patch_count, level_count, leaf_count;
    uint32_t form, has_colors, tree_depth;
    uint32_t holds; /* HOLDS_ ... */
    Bounds bounds;
} Head;

/* A part of the file, and where its address is in a model. */
typedef struct Section {
    void **data;
    size_t bytes, at;
} Section;

uint64_t cache_key(uint64_t input, const char *settings)
{
    return content_hash_bytes(settings, strlen(settings), input);
}

/* Places the sections by the head's counts; returns the size of the file. */
static size_t place_sections(const Head *head, PackedModel *model, float **radii,
                             Section sections[SECTIONS])
{
    Compressed *compressed = &model->compressed;
    const uint32_t holds = head->holds;
    const size_t surfels = head->surfel_count;
    const size_t frames = holds & HOLDS_WORDS ? head->patch_count : 0;
    const Section all[SECTIONS] = {
        { (void **)&model->patches.patches, head->patch_count * sizeof(Patch), 0 },
        { (void **)&model->patches.levels, head->level_count * sizeof(PatchLevel), 0 },
        { (void **)&model->patches.surfels, holds & HOLDS_SURFELS ? surfels * sizeof(Surfel) : 0,
          0 },
        { (void **)&compressed->frames, frames * sizeof(CompressedFrame), 0 },
        { (void **)radii, sizeof compressed->radii, 0 },
        { (void **)&compressed->words, holds & HOLDS_WORDS ? surfels * COMPRESSED_BYTES : 0, 0 },
        { (void **)&compressed->colors, holds & HOLDS_COLORS ? surfels * 3 : 0, 0 },
    };
    size_t at = sizeof(Head);
    for (int i = 0; i < SECTIONS; i++) {
        at = (at + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
        sections[i] = all[i];
        sections[i].at = at;
        at += all[i].bytes;
    }
    return at;
}

static uint64_t hash_all(const Head *head, const char *file, size_t size)
{
    Head zeroed = *head;
    zeroed.hash = 0;
    return content_hash_bytes(file + sizeof zeroed, size - sizeof zeroed,
                              content_hash_bytes(&zeroed, sizeof zeroed, 0));
}

static uint32_t struct_bytes(void)
{
    return (uint32_t)(sizeof(Patch) << 16 | sizeof(PatchLevel) << 8 | sizeof(CompressedFrame));
}

/* --- reading ---------------------------------------------------------------------------------- */

/* What the head says, before anything behind it is believed. */
static GpResult check_head(const char *path, const GpFile *file, uint64_t key, GpError *error)
{
    Head head;
    if (file->size < sizeof head || memcmp(file->data, magic, sizeof magic) != 0)
        return gp_fail(error, GP_ERROR_FORMAT, "%s: not a cache of points", path);
    memcpy(&head, file->data, sizeof head);
    if (head.version != VERSION || head.struct_bytes != struct_bytes())
        return gp_fail(error, GP_ERROR_FORMAT, "%s: a cache of another version", path);
    if (head.key != key)
        return gp_fail(error, GP_ERROR_FORMAT, "%s: a cache of another model or of other settings",
                       path);
    if (head.size > file->size)
        return gp_fail(error, GP_ERROR_FORMAT, "%s: truncated: %zu bytes of %llu", path, file->size,
                       (unsigned long long)head.size);
    if (head.size != file->size || hash_all(&head, file->data, file->size) != head.hash)
        return gp_fail(error, GP_ERROR_FORMAT,
                       "%s: damaged: its content does not have the hash that it says", path);
    return GP_OK;
}

/* Whether patches and levels refer to what is there: a file with a right hash may still be
 * forged. */
static bool refers_inside(const Patches *patches)
{
    if (patches->patch_count == 0)
        return false; /* points are in patches, and there is a point at least */
    const int deepest = tree_depth(patches->leaf_count);
    uint64_t surfel = 0, level = 0;
    for (uint32_t i = 0; i < patches->patch_count; i++) {
        const Patch *patch = &patches->patches[i];
        if (patch->first_level != level || patch->level_count == 0 ||
            level + patch->level_count > patches->level_count || patch->depth > 29 ||
            (patch->level_count > 1 && (int)patch->depth > deepest) ||
            patch->node >> patch->depth != 0)
            return false;
        for (uint32_t k = 0; k < patch->level_count; k++, level++) {
            const PatchLevel *held = &patches->levels[level];
            const uint32_t expected =
                k + 1 < patch->level_count ? patch_child(patches, patch, k, held->count) : 0;
            if (held->first != surfel || held->count == 0 ||
                (expected > 0 && expected != held[1].count))
                return false;
            surfel += held->count;
        }
    }
    return surfel == patches->surfel_count && level == patches->level_count;
}

GpResult cache_read(const char *path, uint64_t key, PackedModel *model, GpError *error)
{
    PackedModel read = { .file = { NULL, 0 } };
    GpResult result = gp_file_read(path, &read.file, error);
    if (!result)
        result = check_head(path, &read.file, key, error);
    if (result) {
        gp_file_free(&read.file);
        return result;
    }
    Head head;
    float *radii;
    Section sections[SECTIONS];
    memcpy(&head, read.file.data, sizeof head);
    const bool fits = place_sections(&head, &read, &radii, sections) == read.file.size;
    for (int i = 0; i < SECTIONS && fits; i++)
        *sections[i].data = sections[i].bytes > 0 ? read.file.data + sections[i].at : NULL;
    read.patches.surfel_count = head.surfel_count;
    read.compressed.surfel_count = head.holds & HOLDS_WORDS ? head.surfel_count : 0;
    read.patches.patch_count = head.patch_count;
    read.patches.level_count = head.level_count;
    read.patches.leaf_count = head.leaf_count;
    read.patches.has_colors = head.has_colors;
    read.patches.bounds = head.bounds;
    read.compressed.form = head.form;
    if (!fits || head.form >= COMPRESS_FORMS || head.leaf_count == 0 ||
        head.tree_depth != (uint32_t)(tree_depth(head.leaf_count) + 1) ||
        !refers_inside(&read.patches)) {
        gp_file_free(&read.file);
        return gp_fail(error, GP_ERROR_FORMAT, "%s: damaged: its parts do not fit together", path);
    }
    memcpy(read.compressed.radii, radii, sizeof read.compressed.radii);
    *model = read;
    return GP_OK;
}

void packed_model_free(PackedModel *model)
{
    if (model->file.data) {
        gp_file_free(&model->file);
    } else {
        patches_free(&model->patches);
        compressed_free(&model->compressed);
    }
    *model = (PackedModel){ .file = { NULL, 0 } };
}

/* --- writing ---------------------------------------------------------------------------------- */

GpResult cache_write(const char *path, uint64_t key, const PackedModel *model, GpError *error)
{
    const Patches *patches = &model->patches;
    const Compressed *compressed = &model->compressed;
    Head head = { .version = VERSION,
                  .struct_bytes = struct_bytes(),
                  .key = key,
                  .surfel_count = patches->surfel_count,
                  .patch_count = patches->patch_count,
                  .level_count = patches->level_count,
                  .leaf_count = patches->leaf_count,
                  .form = compressed->form,
                  .has_colors = patches->has_colors,
                  .bounds = patches->bounds,
                  .holds = (patches->surfels ? HOLDS_SURFELS : 0u) |
                           (compressed->words ? HOLDS_WORDS : 0u) |
                           (compressed->colors ? HOLDS_COLORS : 0u),
                  .tree_depth = (uint32_t)(tree_depth(patches->leaf_count) + 1) };
    memcpy(head.magic, magic, sizeof magic);
    PackedModel copy = *model;
    float *radii = copy.compressed.radii;
    Section sections[SECTIONS];
    head.size = place_sections(&head, &copy, &radii, sections);
    char *file = gp_alloc(head.size, 1);
    if (!file)
        return gp_fail(error, GP_ERROR_MEMORY, "%s: no memory for %llu bytes", path,
                       (unsigned long long)head.size);
    for (int i = 0; i < SECTIONS; i++)
        if (sections[i].bytes > 0)
            memcpy(file + sections[i].at, *sections[i].data, sections[i].bytes);
    head.hash = hash_all(&head, file, head.size);
    memcpy(file, &head, sizeof head);
    const GpResult result = gp_file_write(path, file, head.size, error);
    gp_free(file);
    return result;
}
