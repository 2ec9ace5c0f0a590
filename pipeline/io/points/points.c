#include "pipeline/io/points/points.h"

#include "pipeline/io/file.h"
#include "pipeline/io/points/points_formats.h"

static const struct Format {
    const char *extension;
    bool is_text;
    GpPointsColumns columns;
} formats[] = {
    { .extension = "ply" },
    { .extension = "xyz", .is_text = true, .columns = GP_POINTS_XYZ },
    { .extension = "asc", .is_text = true, .columns = GP_POINTS_XYZ },
    { .extension = "txt", .is_text = true, .columns = GP_POINTS_XYZ },
    { .extension = "xyzn", .is_text = true, .columns = GP_POINTS_XYZN },
    { .extension = "xyzrgb", .is_text = true, .columns = GP_POINTS_XYZRGB },
    { .extension = "pts", .is_text = true, .columns = GP_POINTS_PTS },
};

static const struct Format *find_format(const char *path)
{
    for (size_t i = 0; i < GP_COUNT(formats); i++)
        if (gp_file_has_extension(path, formats[i].extension))
            return &formats[i];
    return NULL;
}

bool gp_points_is_readable(const char *path)
{
    return find_format(path) != NULL;
}

/* The array of an attribute that the file has; its memory is no longer the builder's. */
static void *take(GpBytes *bytes, bool has, bool *failed)
{
    *failed |= has && bytes->failed;
    void *data = has ? bytes->data : NULL;
    if (has)
        *bytes = (GpBytes){ .data = NULL };
    return data;
}

static GpResult finish(const char *path, GpPointsBuilder *builder, GpPoints *points, GpError *error)
{
    bool failed = false;
    const size_t count = builder->positions.size / (3 * sizeof(float));
    GpPoints loaded = { .positions = take(&builder->positions, true, &failed),
                        .normals = take(&builder->normals, builder->has_normals, &failed),
                        .radii = take(&builder->radii, builder->has_radii, &failed),
                        .colors = take(&builder->colors, builder->has_colors, &failed),
                        .count = (uint32_t)count,
                        .face_count = (uint32_t)builder->face_count };
    GpResult result = GP_OK;
    if (failed)
        result = gp_fail(error, GP_ERROR_MEMORY, "%s: no memory for the points", path);
    else if (count == 0 && builder->face_count == 0)
        result = gp_fail(error, GP_ERROR_FORMAT, "%s: no points", path);
    else if (count > (size_t)GP_INPUT_COUNT_MAX)
        result = gp_fail(error, GP_ERROR_UNSUPPORTED, "%s: %zu points are too many", path, count);
    if (result == GP_OK)
        *points = loaded;
    else
        gp_points_free(&loaded);
    return result;
}

GpResult gp_points_read(const char *path, GpPoints *points, GpError *error)
{
    GP_ASSERT(path && points);
    const struct Format *format = find_format(path);
    if (!format)
        return gp_fail(
            error, GP_ERROR_UNSUPPORTED,
            "%s: expected a name that ends with .ply, .xyz, .xyzn, .xyzrgb, .pts, .asc or "
            ".txt",
            path);
    GpFile file;
    GpInput input;
    GpResult result = gp_input_open(path, &file, &input, error);
    if (result != GP_OK)
        return result;
    GpPointsBuilder builder = { .face_count = 0 };
    if (format->is_text)
        gp_points_read_text(&input, format->columns, &builder);
    else
        gp_points_read_ply(&input, &builder);
    gp_file_free(&file);
    result = input.result;
    if (result == GP_OK)
        result = finish(path, &builder, points, error);
    gp_free(builder.positions.data);
    gp_free(builder.normals.data);
    gp_free(builder.radii.data);
    gp_free(builder.colors.data);
    return result;
}

void gp_points_free(GpPoints *points)
{
    if (!points)
        return;
    gp_free(points->positions);
    gp_free(points->normals);
    gp_free(points->radii);
    gp_free(points->colors);
    *points = (GpPoints){ .count = 0 };
}
