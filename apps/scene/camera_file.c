#include "apps/scene/camera_file.h"

#include "apps/base/json_reader.h"
#include "apps/scene/state.h"

GpResult camera_read_file(const char *path, Camera *camera, GpError *error)
{
    Reader reader;
    Camera read = *camera;
    GpResult result = reader_open(&reader, path, error);
    if (result)
        return result;
    Node root = node_root(&reader);
    scene_read_camera(root, &read);
    result = reader.result;
    reader_close(&reader);
    if (!result)
        *camera = read;
    return result;
}
