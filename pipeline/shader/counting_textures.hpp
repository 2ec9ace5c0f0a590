/* Texture reads, kills and what a pixel knows of itself, in counting lanes (as textures.h and
 * pixels.h). gp, the invocation, is asked for because C needs it. */
#ifndef GP_COUNTING_TEXTURES_HPP
#define GP_COUNTING_TEXTURES_HPP

#include "pipeline/shader/counting_instructions.hpp"

namespace
{

template <class... Operands>
float4 gp_read(int slot, GpStepCode code, GpPlace at, const Operands &...operands)
{
    static constexpr GpOp reads[] = {
        { 1, 1, true, GP_NODE_TEXTURE, false, GP_LOD_IMPLICIT }, /* texld */
        { 1, 3, true, GP_NODE_TEXTURE, false, GP_LOD_IMPLICIT }, /* texldp */
        { 1, 6, true, GP_NODE_TEXTURE, false, GP_LOD_BIAS },     /* texldb */
        { 2, 2, true, GP_NODE_TEXTURE, false, GP_LOD_EXPLICIT }, /* texldl */
        { 3, 3, true, GP_NODE_TEXTURE, true, GP_LOD_GRADIENT },  /* texldd */
    };
    const GpOperand list[] = { gp_operand(operands)... };
    return gp_result<float4>(
        gp_graph_add(&reads[code - GP_STEP_TEXLD], code, at, list, int(sizeof...(operands)), slot));
}
inline float4 gp_read_local(int slot, GpPlace at)
{
    static constexpr GpOp GP_OP_LOCAL = { 1, 1, true, GP_NODE_TEXTURE, false, GP_LOD_IMPLICIT };
    return gp_result<float4>(gp_graph_add(&GP_OP_LOCAL, GP_STEP_LOCAL, at, nullptr, 0, slot));
}

#define texld(slot, a)          ((void)gp, gp_read(slot, GP_STEP_TEXLD, gp_here(), a))
#define texldp(slot, a)         ((void)gp, gp_read(slot, GP_STEP_TEXLDP, gp_here(), a))
#define texldb(slot, a)         ((void)gp, gp_read(slot, GP_STEP_TEXLDB, gp_here(), a))
#define texldl(slot, a)         ((void)gp, gp_read(slot, GP_STEP_TEXLDL, gp_here(), a))
#define texldd(slot, a, dx, dy) ((void)gp, gp_read(slot, GP_STEP_TEXLDD, gp_here(), a, dx, dy))
#define gp_load_local(slot)     ((void)gp, gp_read_local(slot, gp_here()))

template <class V> void gp_kill(GpInvocation *, V a, GpPlace at = gp_here())
{
    emit<flt>(GP_OP_TEXKILL, GP_STEP_TEXKILL, at, a);
}
inline void gp_kill(GpInvocation *, msk a, GpPlace at = gp_here())
{
    emit<flt>(GP_OP_TEXKILL, GP_STEP_DISCARD, at, a.value);
}
#define discard(mask) gp_kill(gp, msk(mask))
#define texkill(a)    gp_kill(gp, a)
#define odepth(value) ((void)(gp->depth = (value)))

inline float2 gp_vpos(const GpInvocation *)
{
    return { gp_graph_leaf(GP_NODE_PIXEL, 0), gp_graph_leaf(GP_NODE_PIXEL, 1) };
}
inline flt gp_vface(const GpInvocation *)
{
    return gp_graph_leaf(GP_NODE_FACE, 0);
}
template <class V> void gp_watch(const char *name, const V &value)
{
    const GpOperand whole = gp_operand(value);
    gp_graph_watch(name, &whole);
}
#define watch(name, value) gp_watch(name, value)

#define dsx(a)  ((void)gp, slope_x(a))
#define dsy(a)  ((void)gp, slope_y(a))
#define vpos()  gp_vpos(gp)
#define vface() gp_vface(gp)

} // namespace

#endif
