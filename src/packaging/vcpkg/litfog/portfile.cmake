# SPDX-License-Identifier: Apache-2.0
cmake_path(SET source NORMALIZE ${CURRENT_PORT_DIR}/../../../..)
vcpkg_cmake_configure(SOURCE_PATH ${source} OPTIONS -DLITFOG_BUILD_APPS=OFF -DLITFOG_BUILD_FIT=OFF -DLITFOG_BUILD_GL=OFF
                                                    -DLITFOG_BUILD_TESTS=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/litfog)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE ${CURRENT_PACKAGES_DIR}/debug/include ${CURRENT_PACKAGES_DIR}/debug/share)
vcpkg_install_copyright(FILE_LIST ${source}/LICENSE)
