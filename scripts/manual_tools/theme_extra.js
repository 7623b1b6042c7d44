// Debian's mkdocs leaves out this file of the theme. It gives tables the class that the theme
// styles and makes scrollable.
$('div.rst-content table').addClass('docutils');
