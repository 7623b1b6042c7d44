# Generates the source for game/team_programs/team_templates.hpp from the files of a folder:
#   cmake -DFOLDER=game/team_programs/templates "-DFILES=c/my_team.c c/README.md" -DOUTPUT=... -P embedded_files.cmake
string(REPLACE " " ";" files "${FILES}")
set(source "#include \"game/team_programs/team_templates.hpp\"\n\nnamespace autoref::game {\n\n")
string(APPEND source "std::vector<TemplateFile> template_files() {\n  return {")
foreach(file IN LISTS files)
  file(READ ${FOLDER}/${file} content)
  get_filename_component(name ${file} NAME)
  get_filename_component(language ${file} DIRECTORY)
  string(APPEND source "\n      {\"${language}\", \"${name}\", R\"file(${content})file\"},")
endforeach()
string(APPEND source "};\n}\n\n}  // namespace autoref::game\n")
file(WRITE ${OUTPUT} "${source}")
