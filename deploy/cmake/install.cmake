# What `cmake --install` copies: the programs, and the package for Debian's Python.

include(GNUInstallDirs)
install(TARGETS burnish RUNTIME COMPONENT client)
if(BURNISH_SERVICE)
  install(TARGETS burnish-server RUNTIME COMPONENT server)
  get_target_property(package burnish_python BURNISH_PATH)
  set(python DESTINATION lib/python3/dist-packages/burnish COMPONENT python)
  install(FILES ${package}/burnish/_version.py ${python})
  install(DIRECTORY client/python/burnish/ ${python}
          FILES_MATCHING PATTERN *.py PATTERN py.typed PATTERN __pycache__ EXCLUDE)
  install(DIRECTORY ${package}/burnish/v1 ${python}
          FILES_MATCHING PATTERN *.py PATTERN *.pyi PATTERN __pycache__ EXCLUDE)
endif()
