#pragma once

#include <cstddef>
#include <cstdint>

// Functions for the page's worker (client/web/engine). Each call is a turn of its own: none comes
// while another one runs.
extern "C" {

#define BURNISH_EXPORT(name) __attribute__((visibility("default"), export_name(#name)))

/// Memory for what the worker hands over. The functions below free it.
uint8_t* core_alloc(size_t bytes) BURNISH_EXPORT(core_alloc);
void core_free(uint8_t* memory) BURNISH_EXPORT(core_free);

/// Hears a message of the page (client/web/page/src/protocol.ts) as JSON. `start` has no canvas,
/// and files are {"handle","name","size"}.
void core_hear(uint8_t* text, size_t bytes) BURNISH_EXPORT(core_hear);
/// Handles news and draws if something has changed. Returns the ms until the next call at the
/// latest; infinity: when host_wake() asks for it.
double core_tick(double now_ms) BURNISH_EXPORT(core_tick);

void core_call_message(int call, uint8_t* message, size_t bytes) BURNISH_EXPORT(core_call_message);
/// `code` and `details`: those of gRPC.
void core_call_ended(int call, int code, uint8_t* text, size_t bytes, uint8_t* details,
                     size_t details_bytes) BURNISH_EXPORT(core_call_ended);

/// Returns the checksum of a frame of a live session (common/page_frames/page_frame_header.h).
uint64_t core_frame_checksum(uint8_t* frame, size_t bytes) BURNISH_EXPORT(core_frame_checksum);

/// `rgba`: the size that was asked for, rows from above; null: it is not a picture of this size.
void core_image_decoded(int image, uint8_t* rgba) BURNISH_EXPORT(core_image_decoded);

/// Returns the upper end of a task's stack.
uint8_t* core_stack(int task) BURNISH_EXPORT(core_stack);
/// Runs a task. It returns when the task has ended.
void core_task(int task) BURNISH_EXPORT(core_task);

#undef BURNISH_EXPORT

}  // extern "C"
