#pragma once

/// The OpenCL C++ bindings as haarlight uses them: API 1.1 calls, errors as exceptions.

#define CL_HPP_ENABLE_EXCEPTIONS
#define CL_HPP_TARGET_OPENCL_VERSION 120
#define CL_HPP_MINIMUM_OPENCL_VERSION 110
#include <CL/opencl.hpp>
