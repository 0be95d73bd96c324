# Run by CPack on the files of the Debian package before it is made: what Debian wants beside what is installed.
set(root ${CPACK_TEMPORARY_DIRECTORY}${CPACK_PACKAGING_INSTALL_PREFIX})
set(doc ${root}/${CPACK_BRACKET_DOC})
set(version ${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)  # or SOURCE_DATE_EPOCH

file(WRITE ${doc}/changelog.Debian "bracket (${version}) unstable; urgency=medium

  * Made by cpack; what is new is in the upstream changelog.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
file(WRITE ${doc}/copyright "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: Bracket

Files: *
Copyright: 2026 The Bracket developers
License: GPL-3+
 This program is free software: you can redistribute it and/or modify it under
 the terms of the GNU General Public License as published by the Free Software
 Foundation, either version 3 of the License, or (at your option) any later
 version.
 .
 On Debian systems the text of the license is in
 /usr/share/common-licenses/GPL-3.
")
file(COPY_FILE ${CPACK_BRACKET_SOURCE}/CHANGELOG.md ${doc}/changelog)
execute_process(COMMAND gzip -9nf ${doc}/changelog ${doc}/changelog.Debian ${root}/${CPACK_BRACKET_MAN}/man1/bracket.1
                COMMAND_ERROR_IS_FATAL ANY)
# As the umask of whoever builds may differ: folders 755, files 644 but for what is run.
execute_process(COMMAND chmod -R u=rwX,go=rX ${root} COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE shared ${root}/*.so*)
execute_process(COMMAND chmod 644 ${shared} ${doc}/copyright ${doc}/changelog.gz ${doc}/changelog.Debian.gz
                COMMAND_ERROR_IS_FATAL ANY)
