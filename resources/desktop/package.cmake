# A package for Debian, by ./dev package: cpack -G DEB in the folder of the build. Who builds it is
# named by DEBFULLNAME and DEBEMAIL, as everywhere in Debian.
set(CPACK_PACKAGE_NAME ripstop)
set(packager "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
if(packager MATCHES "^ | <>$")
    set(packager "The developers of Ripstop <ripstop@localhost>")
endif()
set(CPACK_PACKAGE_CONTACT ${packager})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "editor and simulator for fabric that flies")
set(CPACK_PACKAGE_DESCRIPTION
"Kites, hang gliders, parachutes and cloth: made from dimensions or of a
mesh, of real cloth, lines and spars, flown in wind and gusts, tuned while
they fly until they hold, measured, and exported to Blender, ParaView and
papers. The same engine runs without a window, from a terminal or a cluster
job, and gives the same numbers to the last bit.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What libraries load by themselves: the display, and drawing without a card.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "qt6-qpa-plugins, libgl1-mesa-dri")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "ffmpeg, qt6-translations-l10n")
include(CPack)

# What Debian wants beside the programs.
string(TIMESTAMP changelog_date "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(changelog ${CMAKE_CURRENT_BINARY_DIR}/resources/desktop/changelog)
configure_file(resources/desktop/changelog.in ${changelog} @ONLY)
install(CODE "execute_process(COMMAND gzip -9nkf ${changelog} COMMAND_ERROR_IS_FATAL ANY)")
install(FILES ${changelog}.gz resources/desktop/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES resources/desktop/ripstop.overrides DESTINATION share/lintian/overrides
        RENAME ripstop)
