# cmake --install and find_package(rtob).
