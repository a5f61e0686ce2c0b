// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/eval/map_picture.h>

#include "run/map_files.h"

namespace rtob
{
double write_map_files(const OutputFolder& folder, const MapFilesInput& input)
{
    const double resolution_m = write_map_data(folder, input);
    MapPictureInput picture;
    picture.points_map = input.map.points();
    picture.path = input.path;
    picture.title = input.title;
    write_map_picture(folder.file("map.png"), picture);
    return resolution_m;
}
}  // namespace rtob
