# The package for Debian: scripts/package.sh makes and checks it. It is for the release of Debian that it is built on, as
# the names of SFML's libraries differ.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "Flipside authors <maintainers@users.noreply.h-seed-28a10272.example>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# The fonts that the window writes with; what draws a report, and pictures without a display.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "fonts-inter | fonts-dejavu-core")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "gnuplot-nox")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "xvfb, xauth, ffmpeg")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "pinball table on two physics engines, side by side")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"The left half of the window runs a bespoke 2D collision engine that is
written to be read, the right half Box2D. Both get the same scene, the same
controls and the same time step; the window says when and on which part their
balls part company. An exact reference says how far each is from the truth.
.
Everything that the window shows is there without it, from the command line:
runs, comparisons, hard cases, sweeps of error against cost, reports. Engines
of your own take part as shared libraries.")

# Run in the folder that becomes the package.
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_SOURCE_DIR}/debian/finish.cmake)
set(CPACK_FLIPSIDE_DEBIAN ${CMAKE_CURRENT_SOURCE_DIR}/debian)
include(CPack)
