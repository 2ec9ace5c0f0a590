#include "apps/points/drawing/compressed.h"

#include "shaders_c/points/compressed_splat.h"

#include <string.h>

GpSurface *compressed_radii(const Compressed *compressed, Frame *frame)
{
    if (!compressed || compressed->form != COMPRESS_PRINTED)
        return NULL;
    GpSurface *radii = frame_surface(frame, GP_R32F, COMPRESSED_RADII, 1, 1);
    if (radii->level[0].texels)
        memcpy(radii->level[0].texels, compressed->radii, sizeof compressed->radii);
    return radii;
}

static GpGeometry run_geometry(const Compressed *compressed, const SplatRun *run)
{
    const uint8_t *words = compressed->words + (size_t)run->first * COMPRESSED_BYTES;
    GpGeometry geometry = { .primitive = GP_POINTS, .vertex_count = run->count };
    GpStream *streams = geometry.streams;
    if (compressed->form == COMPRESS_PRINTED) {
        streams[GP_TEXCOORD0] = (GpStream){ words, COMPRESSED_BYTES, 4, GP_UINT8 };
        streams[GP_TEXCOORD1] = (GpStream){ words + 4, COMPRESSED_BYTES, 4, GP_UINT8 };
    } else {
        streams[GP_TEXCOORD0] = (GpStream){ words, COMPRESSED_BYTES, 4, GP_UINT16 };
    }
    streams[GP_COLOR] =
        compressed->colors
            ? (GpStream){ compressed->colors + 3 * (size_t)run->first, 3, 3, GP_UNORM8 }
            : (GpStream){ words, COMPRESSED_BYTES, 3, GP_UNORM8 }; /* of no use */
    return geometry;
}

void compressed_draw_runs(const SplatSource *source, const FilterUniforms *uniforms, SplatPass pass,
                          const GpState *state, Frame *frame)
{
    static const GpProgram *const programs[COMPRESS_FORMS][SPLAT_PASSES] = {
        [COMPRESS_OURS] = { &compressed_visibility_program, &compressed_color_program,
                            &compressed_surface_program },
        [COMPRESS_PRINTED] = { &printed_visibility_program, &printed_color_program,
                               &printed_surface_program },
    };
    const Compressed *compressed = source->compressed;
    CompressedUniforms set = { .by_color = compressed->colors ? 1 : 0 };
    for (int k = 0; k < 3 && !compressed->colors; k++)
        set.color[k] = source->color ? (float)source->color[k] / 255 : 1;
    for (uint32_t i = 0; i < source->run_count; i++) {
        const SplatRun *run = &source->runs[i];
        const GpGeometry geometry = run_geometry(compressed, run);
        const SplatUniforms *filtered = splat_run_uniforms(uniforms, run);
        if (run->count == 0 || !filtered) /* without memory */
            continue;
        set.splat = *filtered;
        set.frame = compressed->frames[run->patch];
        GpDraw *draw = frame_draw_copied(frame, programs[compressed->form][pass], &set, &geometry);
        draw->state = *state;
        draw->textures[0].surface = source->radii;
    }
}
