/* Names of states, as scene files write them. */
#include "pipeline/resources/state.h"

const char *const gp_compare_names[GP_COMPARES] = {
    "always", "never", "less", "equal", "less-equal", "greater", "not-equal", "greater-equal",
};

const char *const gp_cull_names[GP_CULLS] = { "none", "cw", "ccw" };

const char *const gp_stencil_op_names[GP_STENCIL_OPS] = {
    "keep", "zero", "replace", "incr-sat", "decr-sat", "invert", "incr", "decr",
};

const char *const gp_blend_op_names[GP_BLEND_OPS] = {
    "off", "add", "subtract", "rev-subtract", "min", "max", "logic-and", "logic-or", "logic-xor",
};

const char *const gp_blend_factor_names[GP_BLEND_FACTORS] = {
    "zero",          "one",        "src-color",      "inv-src-color", "src-alpha",
    "inv-src-alpha", "dest-alpha", "inv-dest-alpha", "dest-color",    "inv-dest-color",
    "src-alpha-sat", "constant",   "inv-constant",
};

const char *const gp_order_names[GP_ORDERS] = { "submitted", "depth", "depth-near-first" };

const char *const gp_filter_names[GP_FILTERS] = { "point", "linear" };

const char *const gp_mip_filter_names[GP_MIP_FILTERS] = { "none", "point", "linear" };

const char *const gp_address_names[GP_ADDRESSES] = {
    "wrap", "mirror", "clamp", "border", "mirror-once",
};
