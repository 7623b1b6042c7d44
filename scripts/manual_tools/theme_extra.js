// Debian's mkdocs leaves this file of the theme out. Tables get the class that the theme styles and lets scroll.
$('div.rst-content table').addClass('docutils');
