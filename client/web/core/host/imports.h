#pragma once

#include <cstddef>
#include <cstdint>

// Functions of the page's worker (client/web/engine). Texts and bytes are places and
// lengths in this memory, texts are UTF-8. Only task_suspend() waits.
extern "C" {

#define BURNISH_IMPORT(name) __attribute__((import_module("host"), import_name(#name)))

/// Says a message of client/web/page/src/protocol.ts as JSON.
void host_say(const char* text, size_t bytes) BURNISH_IMPORT(say);
/// Shows a picture in the canvas, rows from above. Only for the core that draws with the processor.
void host_show_picture(const uint8_t* rgb, int width, int height) BURNISH_IMPORT(show_picture);
/// Has core_tick() called with the next picture.
void host_wake() BURNISH_IMPORT(wake);

/// Has core_task(task) called on a stack of its own, not within this call.
void host_task_start(int task) BURNISH_IMPORT(task_start);
/// Returns when task_resume(task) has been called, before or after. Needs: the task's stack.
void host_task_suspend(int task) BURNISH_IMPORT(task_suspend);
void host_task_resume(int task) BURNISH_IMPORT(task_resume);

/// Begins a call, e.g. "burnish.v1.Editing/Edit", at a server of a fleet or at any. One message may
/// be handed over at first.
int host_call_open(const char* method, size_t bytes, const char* node, size_t node_bytes)
    BURNISH_IMPORT(call_open);
void host_call_send(int call, const uint8_t* message, size_t bytes) BURNISH_IMPORT(call_send);
void host_call_end(int call) BURNISH_IMPORT(call_end);
void host_call_cancel(int call) BURNISH_IMPORT(call_cancel);
/// Returns the bytes that are not on the link yet.
size_t host_call_buffered(int call) BURNISH_IMPORT(call_buffered);
/// Lets one more message be handed over.
void host_call_pull(int call) BURNISH_IMPORT(call_pull);

/// Returns how many bytes were read: fewer at the end, or where the file has changed.
size_t host_file_read(int file, double offset, uint8_t* to, size_t bytes) BURNISH_IMPORT(file_read);

int host_download_begin(const char* name, size_t bytes) BURNISH_IMPORT(download_begin);
void host_download_add(int download, const uint8_t* part, size_t bytes)
    BURNISH_IMPORT(download_add);
/// `keep`: 0 drops it.
void host_download_end(int download, int keep) BURNISH_IMPORT(download_end);

// Small texts that outlive the page.
void host_store_set(const char* key, size_t key_bytes, const char* text, size_t bytes)
    BURNISH_IMPORT(store_set);
/// Returns the text's length; store_take() then writes it.
size_t host_store_get(const char* key, size_t key_bytes) BURNISH_IMPORT(store_get);
void host_store_take(char* to) BURNISH_IMPORT(store_take);
/// Keeps a picture as the text of a key, some time later: the address of a file within itself.
void host_picture_keep(const char* key, size_t key_bytes, const uint8_t* rgb, int width, int height)
    BURNISH_IMPORT(picture_keep);

/// Begins to decode a WebP of this size, which is opaque. core_image_decoded() follows, not within
/// this call.
int host_image_decode(const uint8_t* file, size_t bytes, int width, int height)
    BURNISH_IMPORT(image_decode);

#undef BURNISH_IMPORT

}  // extern "C"
