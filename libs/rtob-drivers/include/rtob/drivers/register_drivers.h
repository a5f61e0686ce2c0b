// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace rtob
{
/// Makes this library's sensors known to MRPT by their names. Loading the library as a plug-in
/// (`rawlog-grabber -p librtob-drivers.so`) does the same; a program that links it has to call
/// this, or the linker drops a library of which nothing is used. May be called again.
void register_drivers();
}  // namespace rtob
