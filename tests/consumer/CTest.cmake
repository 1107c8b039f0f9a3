# The outside project is built and run against the installed package.
add_test(NAME consumer COMMAND ${CMAKE_COMMAND}
    -D SOURCE=${PROJECT_SOURCE_DIR} -D BUILD=${PROJECT_BINARY_DIR} -D SCRATCH=${PROJECT_BINARY_DIR}/consumer
    -D GENERATOR=${CMAKE_GENERATOR} -D COMPILER=${CMAKE_CXX_COMPILER} -D FLAGS=${CMAKE_CXX_FLAGS}
    -P ${CMAKE_CURRENT_LIST_DIR}/RunConsumer.cmake)
set_tests_properties(consumer PROPERTIES TIMEOUT 900)
