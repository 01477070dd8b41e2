# What `cmake --install` copies: the programs, and the package for Debian's Python.

include(GNUInstallDirs)
install(TARGETS burnish RUNTIME)
if(BURNISH_SERVICE)
  install(TARGETS burnish-server RUNTIME)
  get_target_property(package burnish_python BURNISH_PATH)
  install(DIRECTORY client/python/burnish DESTINATION lib/python3/dist-packages
          FILES_MATCHING PATTERN *.py PATTERN py.typed PATTERN __pycache__ EXCLUDE)
  install(DIRECTORY ${package}/burnish/v1 DESTINATION lib/python3/dist-packages/burnish
          FILES_MATCHING PATTERN *.py PATTERN *.pyi PATTERN __pycache__ EXCLUDE)
endif()
