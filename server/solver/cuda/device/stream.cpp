#include "server/solver/cuda/device/stream.h"

namespace burnish::cuda {

Status cuda_status(cudaError_t error, const char* what) {
  if (error == cudaSuccess) return Status::ok();
  const std::string text = std::string("CUDA: ") + what + ": " + cudaGetErrorName(error) + ": " +
                           cudaGetErrorString(error);
  return error == cudaErrorMemoryAllocation ? resource_exhausted(text) : internal_error(text);
}

Stream::Stream(int device, Urgency urgency) : device_(device) {
  use_device();
  int least = 0, greatest = 0;
  check(cudaDeviceGetStreamPriorityRange(&least, &greatest), "asking the device");
  const int priority = urgency == Urgency::kFirst ? greatest : least;
  check(cudaStreamCreateWithPriority(&stream_, cudaStreamNonBlocking, priority),
        "creating a stream");
  int major = 0;
  check(cudaDeviceGetAttribute(&major, cudaDevAttrComputeCapabilityMajor, device),
        "asking the device");
  starts_early_ = major >= 9;
}

Stream::~Stream() {
  if (stream_ != nullptr) cudaStreamDestroy(stream_);
}

// If there is no such device, the next call of CUDA says so.
void Stream::use_device() const {
  int current = -1;
  if (cudaGetDevice(&current) != cudaSuccess || current != device_) cudaSetDevice(device_);
}

bool Stream::check(cudaError_t error, const char* what) {
  return error == cudaSuccess ? is_ok() : check(cuda_status(error, what));
}

bool Stream::check(const Status& status) {
  if (is_ok()) status_ = status;
  return is_ok();
}

bool Stream::synchronize() {
  return is_ok() && check(cudaStreamSynchronize(stream_), "waiting for the device");
}

}  // namespace burnish::cuda
