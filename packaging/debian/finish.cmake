# What a package of Debian has beyond what is installed elsewhere: the licences of all that is inside, what changed, and
# both that and the man pages compressed, without a name or a time inside.
set(share ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr/share)
file(COPY ${CPACK_FLIPSIDE_DEBIAN}/copyright ${CPACK_FLIPSIDE_DEBIAN}/changelog DESTINATION ${share}/doc/flipside)
file(GLOB pages ${share}/man/man1/*.1)
execute_process(COMMAND gzip -9n ${share}/doc/flipside/changelog ${pages} COMMAND_ERROR_IS_FATAL ANY)
