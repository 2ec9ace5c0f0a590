/* A camera from a file of its own: what a scene has as its "camera". */
#ifndef APPS_SCENE_CAMERA_FILE_H
#define APPS_SCENE_CAMERA_FILE_H

#include "apps/base/camera.h"
#include "pipeline/base/base.h"

/* Members that are not there stay as they were.
 * errors those of reader_open; GP_ERROR_FORMAT with file, line and member; camera is then
 *      untouched */
GpResult camera_read_file(const char *path, Camera *camera, GpError *error);

#endif
