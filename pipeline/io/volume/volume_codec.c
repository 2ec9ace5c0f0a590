#include "pipeline/io/volume/volume_codec.h"

#include <string.h>

bool gp_volume_type_of(const char *name, GpVolumeType *type)
{
    static const struct {
        const char *name;
        GpVolumeType type;
    } names[] = {
        { "uint8", GP_VOLUME_U8 },           { "uchar", GP_VOLUME_U8 },
        { "unsigned char", GP_VOLUME_U8 },   { "uint8_t", GP_VOLUME_U8 },
        { "uint16", GP_VOLUME_U16 },         { "ushort", GP_VOLUME_U16 },
        { "unsigned short", GP_VOLUME_U16 }, { "unsigned short int", GP_VOLUME_U16 },
        { "uint16_t", GP_VOLUME_U16 },       { "int16", GP_VOLUME_I16 },
        { "short", GP_VOLUME_I16 },          { "short int", GP_VOLUME_I16 },
        { "signed short", GP_VOLUME_I16 },   { "signed short int", GP_VOLUME_I16 },
        { "int16_t", GP_VOLUME_I16 },        { "float", GP_VOLUME_F32 },
        { "float32", GP_VOLUME_F32 },
    };
    for (size_t i = 0; i < GP_COUNT(names); i++) {
        if (strcmp(name, names[i].name) == 0) {
            *type = names[i].type;
            return true;
        }
    }
    return false;
}
