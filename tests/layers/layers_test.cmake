# SPDX-License-Identifier: Apache-2.0
# Includes run one way only:
#
#     core  <-  photometry, files, gl  <-  fit;   c on core and files, python on fit and files           (src)
#     within the core: model, text  <-  solve, airlight  <-  culling  <-  tables
#     command  <-  image  <-  scene  <-  render  <-  measure  <-  drawing  <-  demo, window, pictures;
#     papers on drawing, demo on papers; bench on measure;
#     solve and fit on command alone; browser on scene and what of render and window WebGL 2 can hold    (apps)
#
# cmake -DROOT=<the repository> -P layers_test.cmake

set(failures 0)

# layer(<files, a glob below ROOT>... FORBIDDEN <what no include there begins with>...)
function(layer)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "" "FORBIDDEN")
  list(JOIN arg_FORBIDDEN "|" forbidden)
  foreach(glob IN LISTS arg_UNPARSED_ARGUMENTS)
    if(glob MATCHES "\\*\\*$")
      string(REPLACE "**" "*" recursive "${glob}")
      file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/${recursive})
    else()
      file(GLOB files RELATIVE ${ROOT} ${ROOT}/${glob})
    endif()
    list(FILTER files INCLUDE REGEX "\\.(h|cpp)$")
    if(NOT files)
      message("${glob}: holds no sources")
      math(EXPR failures "${failures} + 1")
    endif()
    foreach(file IN LISTS files)
      file(STRINGS ${ROOT}/${file} includes REGEX "^ *# *include *[<\"](${forbidden})")
      foreach(include IN LISTS includes)
        message("${file}: ${include}: must not be included there")
        math(EXPR failures "${failures} + 1")
      endforeach()
    endforeach()
  endforeach()
  set(failures ${failures} PARENT_SCOPE)
endfunction()

set(ceres ceres/ Eigen/)
set(json nlohmann/ rapidjson/)
set(graphics epoxy/ EGL/ GL/)
set(images OpenImageIO/ openexr ImfC webp/)
set(containers pugixml unzip.h zip.h uchardet)
set(meshes draco/ meshoptimizer)
set(displays GLFW/ imgui backends/imgui)
set(foreign ${ceres} ${json} ${graphics} ${images} ${containers} ${meshes} ${displays} CLI/)
set(commands command/ image/ scene/ render/ measure/ drawing/ papers/ solve/ demo/ bench/ pictures/)

# src. The public headers show no other library but GLM.
# src has a solve/ of its own.
set(apps command/ image/ scene/ render/ measure/ drawing/ papers/ demo/ bench/ window/ pictures/)
set(photometry photometry/ litfog/photometry/)
set(files files/ litfog/files/)
set(gl gl/ litfog/gl/)
set(fit fit/ litfog/fit/)
set(core src/model/* src/text/* src/solve/* src/airlight/* src/culling/* src/tables/*)
layer(${core} include/litfog/* FORBIDDEN ${apps} ${photometry} ${files} ${gl} ${fit} ${foreign} fmt/)
layer(src/model/* src/text/* FORBIDDEN solve/ airlight/ culling/ tables/)
layer(src/solve/* FORBIDDEN airlight/ culling/ tables/)
layer(src/airlight/* FORBIDDEN culling/ tables/)
layer(src/culling/* FORBIDDEN tables/)
layer(src/photometry/** FORBIDDEN ${apps} ${files} ${gl} ${fit} ${ceres} ${json} ${graphics} OpenImageIO/)
layer(src/gl/** FORBIDDEN ${apps} ${photometry} ${files} ${fit} ${ceres} ${json} ${images})
layer(src/c/** FORBIDDEN ${apps} ${photometry} ${gl} ${fit} ${foreign} fmt/)
layer(src/python/** FORBIDDEN ${apps} ${gl} ${foreign} fmt/)
layer(src/fit/** FORBIDDEN ${apps} ${gl} ${json} ${graphics} ${images} ${containers})
layer(include/litfog/photometry/** FORBIDDEN ${files} ${gl} ${fit})
layer(include/litfog/gl/** FORBIDDEN ${photometry} ${files} ${fit})
layer(include/litfog/fit/** FORBIDDEN ${gl})
layer(include/litfog/** FORBIDDEN ${apps} ${foreign} fmt/)
layer(include/litfog/c/litfog.h FORBIDDEN litfog/ glm/)  # C knows neither

# apps. Scene data and the renderer know no file; only the scenes' readers do.
set(catalogues scene/model/ scene/paint/)
set(above_measure drawing/ papers/ demo/ bench/ window/)
set(above_scene render/ measure/ ${above_measure})
layer(apps/** FORBIDDEN ${containers})
# Only image/ knows OpenImageIO, so that a command starts without it.
layer(apps/command/** apps/fit/** apps/scene/** apps/render/** apps/measure/** apps/drawing/** apps/papers/**
      apps/demo/** apps/window/** apps/bench/** apps/pictures/** FORBIDDEN OpenImageIO/)
layer(apps/image/** FORBIDDEN scene/ solve/ ${above_scene} ${fit} ${gl} ${graphics})
layer(apps/command/** FORBIDDEN image/ scene/ solve/ ${above_scene} ${fit} ${gl} ${graphics})
layer(apps/scene/* FORBIDDEN command/ image/ scene/file/ ${catalogues} ${above_scene} ${files} ${gl} ${fit} ${foreign}
      fmt/)
layer(apps/scene/model/** apps/scene/paint/** FORBIDDEN command/ image/ scene/file/ ${above_scene} ${files}
      ${gl} ${foreign})
layer(apps/scene/file/** FORBIDDEN ${above_scene} ${gl} ${graphics})
layer(apps/render/** FORBIDDEN command/ image/ scene/file/ ${catalogues} measure/ ${above_measure} litfog/files/ ${fit}
      ${ceres} ${json} ${images} ${displays} CLI/)
layer(apps/measure/** FORBIDDEN command/ image/ scene/file/ ${catalogues} ${above_measure} litfog/files/ ${fit}
      ceres/ ${json} ${displays} CLI/)
layer(apps/drawing/** FORBIDDEN papers/ demo/ solve/ fit/ bench/ window/ pictures/ ${displays})
layer(apps/papers/** FORBIDDEN demo/ solve/ fit/ bench/ window/ pictures/ ${displays})
layer(apps/demo/** FORBIDDEN solve/ fit/ bench/ window/ ${displays})
layer(apps/window/** FORBIDDEN papers/ demo/ solve/ fit/ bench/ pictures/)
layer(apps/pictures/** FORBIDDEN papers/ demo/ solve/ fit/ bench/ window/ ${json} ${graphics} ${images} ${displays})
layer(apps/browser/** FORBIDDEN command/ image/ scene/file/ measure/ drawing/ papers/ demo/ solve/ fit/ bench/ ${files}
      ${fit} ${ceres} ${json} ${images} ${displays} CLI/)
layer(apps/solve/** apps/fit/** FORBIDDEN image/ scene/ ${above_scene} ${gl} ${graphics})
layer(apps/examples/** FORBIDDEN ${commands})  # they know what is installed
layer(apps/bench/** FORBIDDEN papers/ demo/ window/ solve/ fit/ core/ gl/)  # of tests/ it may know reference/

# tests. Only the benchmark's know its sources; what the benchmark takes from here is reference/.
layer(tests/reference/** FORBIDDEN ${apps} core/ ${files} ${gl})
layer(tests/core/** tests/c/** tests/photometry/** FORBIDDEN scene/ ${above_scene} ${gl} ${fit} ${ceres} ${graphics})
layer(tests/gl/** tests/fit/** FORBIDDEN scene/ ${above_scene})
layer(tests/scene/** FORBIDDEN gl/ ${above_scene} ${gl} ${graphics})
layer(tests/scene/** tests/render/** tests/measure/** tests/demo/** tests/solve/** FORBIDDEN bench/)

if(failures GREATER 0)
  message(FATAL_ERROR "${failures} includes against the layers")
endif()
