# kerfline_describe_version(RESULT SOURCE VERSION): the project's VERSION and, where SOURCE is the
# top of a git work tree, the commit: `0.2.0+9fa115e`. `-dirty` follows if the tree is modified: a
# tracked file differs from the commit, or a file of the product's folders, which the build may
# take up, is in no commit. Without git RESULT is VERSION alone.
function(kerfline_describe_version result source version)
  set(${result} ${version} PARENT_SCOPE)
  find_program(KERFLINE_GIT git)
  if(NOT KERFLINE_GIT)
    return()
  endif()
  # Builds of other users may read the work tree, too, and reading must not lock the index.
  set(git ${KERFLINE_GIT} --no-optional-locks -c safe.directory=* -C ${source})
  execute_process(COMMAND ${git} rev-parse --show-prefix --verify HEAD
    OUTPUT_VARIABLE commit ERROR_QUIET RESULT_VARIABLE failed)
  # An empty first line: SOURCE is the top, and not a copy inside the work tree of another project.
  if(failed OR NOT commit MATCHES "^\n([0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f])")
    return()
  endif()
  set(described ${version}+${CMAKE_MATCH_1})
  execute_process(COMMAND ${git} status --porcelain --untracked-files=all
    OUTPUT_VARIABLE changes ERROR_QUIET)
  if(changes MATCHES "(^|\n)([^?]|\\?\\? (planner|hal|firmware|host-sim|toolchain)/)")
    string(APPEND described -dirty)
  endif()
  set(${result} ${described} PARENT_SCOPE)
endfunction()
