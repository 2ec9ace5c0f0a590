/* What C++ does where memory ends: the counting builds of shaders, OpenImageIO and OpenMesh. */
#ifndef GP_IO_NO_MEMORY_H
#define GP_IO_NO_MEMORY_H

#ifdef __cplusplus
extern "C" {
#endif

/* Has `end` called, in whatever thread, where C++ finds no memory. It does not return: exceptions of
 * libraries that are being loaded, or in their own threads, could not be caught. */
void gp_call_without_memory(void (*end)(void));

#ifdef __cplusplus
}
#endif

#endif
