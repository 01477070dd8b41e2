# Sets BURNISH_CUDA to ON or OFF for the rest of the tree: whether to build the CUDA backend.

if(BURNISH_CUDA STREQUAL "AUTO")
  find_program(BURNISH_NVCC nvcc HINTS ENV CUDA_PATH /usr/local/cuda PATH_SUFFIXES bin)
  if(BURNISH_NVCC AND NOT BURNISH_SANITIZE)
    set(BURNISH_CUDA ON)
  else()
    set(BURNISH_CUDA OFF)
  endif()
  message(STATUS "CUDA backend: ${BURNISH_CUDA}")
endif()

if(BURNISH_CUDA)
  if(NOT DEFINED CMAKE_CUDA_COMPILER AND BURNISH_NVCC)
    set(CMAKE_CUDA_COMPILER ${BURNISH_NVCC})
  endif()
  # Code for the cards of 2018 to 2023, and PTX of the last for newer cards.
  if(NOT DEFINED CMAKE_CUDA_ARCHITECTURES)
    set(CMAKE_CUDA_ARCHITECTURES "75-real;80-real;86-real;89-real;90")
  endif()
  enable_language(CUDA)
  find_package(CUDAToolkit REQUIRED)
  # CMake 3.25 does not know that nvcc 13 speaks C++20.
  if(NOT CMAKE_CUDA20_STANDARD_COMPILE_OPTION)
    set(CMAKE_CUDA20_STANDARD_COMPILE_OPTION "-std=c++20")
  endif()
  string(APPEND CMAKE_CUDA_FLAGS " --expt-relaxed-constexpr")
endif()
