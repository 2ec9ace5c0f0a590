/* Voxelization: models into volumes, by passes that end in a flat texture. */
#ifndef APPS_TECHNIQUES_VOXEL_METHODS_VOXELIZE_H
#define APPS_TECHNIQUES_VOXEL_METHODS_VOXELIZE_H

#include "apps/techniques/voxel/volume/box.h"
#include "apps/techniques/voxel/volume/flat_texture.h"
#include "shaders_c/voxel/methods/motion.h"

typedef enum VoxelKind { VOXEL_SURFACE, VOXEL_SOLID } VoxelKind;

typedef enum VoxelMethod {
    VOXEL_AUTO,         /* conservative for surfaces, xor for solids */
    VOXEL_CONSERVATIVE, /* surface: every voxel that a triangle touches */
    VOXEL_THIN,         /* surface: voxels met by lines through middles, along three axes */
    VOXEL_XOR,          /* solid: each fragment turns over what is below it */
    VOXEL_SHEETS, /* as printed: three directional flat textures, synthesized; solid: row scans */
    VOXEL_SLICES, /* baseline: one pass a slice, between clip planes (Fang and Chen 2000) */
    VOXEL_LDI,    /* baseline: layered depth images by peeling (Heidelberger et al. 2003) */
    VOXEL_FACES,  /* baseline: depth buffers of the box's six faces (Karabassi et al. 1999) */
} VoxelMethod;

typedef enum VoxelBlend { VOXEL_ADD, VOXEL_OR } VoxelBlend;

/* What a voxel of 8 or 16 bits holds. */
typedef enum VoxelValue { VOXEL_DENSITY, VOXEL_NORMAL, VOXEL_COLOR } VoxelValue;

typedef struct VoxelSetting {
    int kind, method; /* of the enumerations above */
    uint32_t size;    /* voxels a side */
    uint32_t bits;    /* a voxel: 1, 8, 16 */
    int blend;        /* of the printed method: VoxelBlend */
    uint32_t axes;    /* of the printed method: 3, or 1: along z only */
    int value;        /* VoxelValue, of 8 and 16 bits */
} VoxelSetting;

extern const VoxelSetting voxel_defaults;

/* What may be set between frames of a model that moves: one for each draw. Rigid motions, or twists
 * (conservative, thin and xor only; 0 otherwise). */
enum { VOXEL_MAX_MOTIONS = 1024 };
typedef struct VoxelMotions {
    VoxelMotion *motion[VOXEL_MAX_MOTIONS]; /* in the uniforms of draws */
    uint32_t count;
} VoxelMotions;

/* Sets a motion in all draws that were appended with these motions, for the next frame. */
void voxel_move(const VoxelMotions *motions, const VoxelMotion *motion);

/* The motion of a model that stands in its box. */
VoxelMotion voxel_still(const VoxelBox *box);

/* Triangles of a model, borrowed. */
typedef struct VoxelModel {
    const float *positions;        /* [3 * vertex_count] */
    const float *normals, *colors; /* [3 * ..], [4 * ..]; NULL: none */
    const uint32_t *indices;       /* [3 * triangle_count] */
    uint32_t vertex_count, triangle_count;
    VoxelMotion motion;    /* into the volume: voxel_still, or a motion before it */
    VoxelMotions *motions; /* NULL: it stands still */
    float most_twist;      /* of a motion that may be set later */
} VoxelModel;

/* Appends the passes of a setting to a work in which there is room (tech_voxel_room).
 * in     sheet: of the setting's size and bits; its texels are right once the list has run
 * errors GP_ERROR_INVALID: the setting contradicts itself, with the reason */
GpResult tech_voxel_draw(const VoxelModel *model, const VoxelSetting *setting, Frame *frame,
                         const FlatTexture *sheet, GpError *error);

/* The same into a flat texture that is made for it.
 * errors also those of flat_texture_check */
GpResult tech_voxel_build(const VoxelModel *model, const VoxelSetting *setting, Frame *frame,
                          FlatTexture *sheet, GpError *error);

/* Upper bounds of the passes and draws that a setting appends, for frame_reserve. */
void tech_voxel_room(const VoxelSetting *setting, uint32_t *passes, uint32_t *draws);

#endif
