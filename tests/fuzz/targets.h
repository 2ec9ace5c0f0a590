/* The targets by file: each reads what its name says. */
#ifndef TESTS_FUZZ_TARGETS_H
#define TESTS_FUZZ_TARGETS_H

#include "tests/fuzz/fuzz.h"

extern const FuzzTarget fuzz_mesh_off, fuzz_mesh_obj, fuzz_mesh_ply, fuzz_mesh_stl, fuzz_mesh_om;
extern const FuzzTarget fuzz_picture_png, fuzz_picture_pfm, fuzz_picture_ppm, fuzz_picture_tga,
    fuzz_picture_exr, fuzz_layers;
extern const FuzzTarget fuzz_volume_nrrd, fuzz_volume_raw, fuzz_volume_bits;
extern const FuzzTarget fuzz_points_ply, fuzz_points_text;
extern const FuzzTarget fuzz_scene, fuzz_camera, fuzz_rgbd, fuzz_transfer;
extern const FuzzTarget fuzz_chart, fuzz_measured;
extern const FuzzTarget fuzz_cache, fuzz_pieces;
extern const FuzzTarget fuzz_polynomial, fuzz_options;
extern const FuzzTarget fuzz_path_file, fuzz_journal, fuzz_lesson;
extern const FuzzTarget fuzz_list;

#endif
