#!/bin/sh
# What compilers say of mistakes in a shader, and what becomes of flags that change bits:
#
#   check_snippets.sh INCLUDE LIBRARY     as TAP, with every compiler of gcc and clang that is there
#
# A line of mistakes is "STATEMENT # WORDS": compiled inside a pixel shader, the statement is refused with
# words of ours. All stand in one file, since each is refused by itself.
include=$1 library=$2
. tests/tools/tap.sh
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

mistakes() {
    cat <<'EOF'
v = mul(2.0f, v); # mul(a, b): a must be a flt or a vector
v = add(v, uv); # add(a, b): a must be a flt or a vector, and what goes with it as wide as a
v = mad(v, 2, uv); # mad(a, b, c): a must be a flt or a vector, and what goes with it as wide as a
v = lrp(uv, v, v); # lrp(t, a, b): a must be a flt or a vector, and what goes with it as wide as a
v = cmp(v, 1, v); # cmp(s, a, b): a must be a flt or a vector
v = sel(v.x, v, v); # sel(mask, a, b): mask must be a comparison of flt
v = sat(1); # sat(a): a must be a flt or a vector
v = nrm(v.x); # nrm(v): v must be a float2, a float3 or a float4
v = vec3(v, 1, 2); # rgba, vec2, vec3, vec4: each component must be a flt or a number
v = xyz(m4x4(uv, c->m)); # m4x4(v, m): v must be a float3 or a float4
v = xyz(texld(0, v.x)); # texld(slot, a): a coordinate must be a float2, a float3 or a float4
v = dsx(v.x > 0.0f); # dsx(a): a must be a flt or a vector
EOF
}

# shader STATEMENTS: a file of shaders
shader() {
    cat <<EOF
#include <glasspipe/glasspipe.h>
#include <glasspipe/shader.h>
typedef struct U { float m[4][4]; } U;
typedef struct In { float2 position; } In;
typedef struct Out { float3 color; float2 uv; } Out;
vertex_shader(vs, U, In, Out)
{
    *position = vec4(in->position.x, in->position.y, 0.5f, 1);
    out->color = vec3(in->position.x, in->position.y, 1);
    out->uv = in->position;
}
pixel_shader(ps, U, Out)
{
    float3 v = in->color;
    float2 uv = in->uv;
    $1
    return rgba(v, uv.x);
}
program(snippet, vs, ps, .varyings = { { "color", 3, GP_PERSPECTIVE }, { "uv", 2, GP_PERSPECTIVE } },
        .pixel_profile = GP_PS_2_0, .inputs = { { GP_POSITION, 2 } }, .vertex_profile = GP_VS_2_0)
EOF
}

# A program that draws with it, and prints the hash or what is wrong.
main_program() {
    cat <<'EOF'
#include <stdio.h>
int main(void)
{
    static const float corners[6] = { -1, -1, 1, -1, 0, 0.7f };
    GpError error;
    GpSurface *picture;
    GpDevice *device;
    GpSurfaceDesc desc = { .format = GP_A8R8G8B8, .width = 64, .height = 64 };
    GpDraw draw = { .program = &snippet, .uniforms = &(U){ { { 1 } } }, .geometry.vertex_count = 3 };
    draw.geometry.streams[GP_POSITION] = (GpStream){ corners, 8, 2, GP_FLOAT32 };
    if (gp_surface_create(&desc, &picture, &error))
        return 1;
    GpPass pass = { .color[0] = { .surface = picture, .clear = true }, .draws = &draw,
                    .draw_count = 1 };
    if (gp_device_create(&(GpDeviceDesc){ 0 }, &device, &error) ||
        gp_device_run(device, &(GpList){ &pass, 1 }, &error))
        return puts(error.text), 1;
    printf("hash %016llx\n", (unsigned long long)gp_surface_hash(picture));
    gp_device_destroy(&device);
    gp_surface_destroy(&picture);
    return 0;
}
EOF
}

# says COMPILER WORDS NAME FILE FLAGS...: refused with these words
says() {
    compiler=$1 words=$2 name=$3 file=$4
    shift 4
    if $compiler -I"$include" "$@" -fsyntax-only "$file" >"$scratch/said" 2>&1; then
        result "not ok" "$compiler: $name is compiled"
    elif grep -qF "$words" "$scratch/said"; then
        result ok "$compiler: $name"
    else
        head -5 "$scratch/said" | sed 's/^/# /'
        result "not ok" "$compiler: $name: does not say '$words'"
    fi
}

# draws COMPILER FLAGS...: what the program prints
draws() {
    "$@" -I"$include" "$scratch/program.c" "$library" -pthread -lm -o "$scratch/program" \
        >"$scratch/said" 2>&1 || { head -3 "$scratch/said"; return; }
    "$scratch/program"
}

check_compiler() {
    compiler=$1
    shader "$(mistakes | sed 's/ #.*//')" >"$scratch/mistakes.c"
    case $compiler in clang) all=-ferror-limit=0 ;; *) all= ;; esac
    # shellcheck disable=SC2086 # none, or one
    $compiler $all -I"$include" -fsyntax-only "$scratch/mistakes.c" >"$scratch/all" 2>&1
    mistakes | while read -r line; do
        statement=${line% # *} words=${line#* # }
        if grep -qF "$words" "$scratch/all"; then
            echo "$compiler: $statement"
        else
            echo "not $compiler: $statement does not say '$words'"
        fi
    done >"$scratch/results"
    while read -r line; do
        case $line in
        not*) result "not ok" "${line#not }" ;;
        *) result ok "$line" ;;
        esac
    done <"$scratch/results"

    shader "v = mad(nrm(v), 2, cmp(v.x, uv.x, 1.5f));" >"$scratch/shader.c"
    { cat "$scratch/shader.c" && main_program; } >"$scratch/program.c"
    says "$compiler" "with -ffast-math" "-ffast-math" "$scratch/shader.c" -ffast-math
    says "$compiler" "with -ffast-math" "-ffinite-math-only" "$scratch/shader.c" -ffinite-math-only
    says "$compiler" "a shader file has no main" "main beside shaders at 8 lanes" \
        "$scratch/program.c" -DGP_LANES=8
    hash=$(draws "$compiler" -O2)
    case $hash in
    hash*) result ok "$compiler: without any flag: $hash" ;;
    # where multiplications are fused by default
    *"rounds a * b + c once"*) result ok "$compiler: without any flag: $hash" ;;
    *) result "not ok" "$compiler: without any flag: $hash" ;;
    esac
    if ! grep -qw fma /proc/cpuinfo; then
        result ok "$compiler: -mfma # SKIP this processor has none"
        return
    fi
    fused=$(draws "$compiler" -O2 -mfma)
    case $fused in
    "$hash" | *"program snippet: its generic code rounds a * b + c once"*) name=ok ;;
    *) name="not ok" ;;
    esac
    result "$name" "$compiler: -mfma: $fused"
    exact=$(draws "$compiler" -O2 -mfma -ffp-contract=off)
    [ "$exact" = "$hash" ] && name=ok || name="not ok"
    result "$name" "$compiler: -mfma -ffp-contract=off: $exact"
}

for compiler in gcc clang; do
    if command -v $compiler >/dev/null; then
        check_compiler $compiler
    else
        result ok "$compiler # SKIP not installed"
    fi
done
echo "1..$count"
exit $failed
