// Looks for words in the pages. The list of all sections is a script of its own,
// search/sections.js, since browsers read no other file beside a page that comes from a disk.
(function () {
  "use strict";

  function wordsOf(text) {
    return text.toLowerCase().split(/\s+/).filter(function (word) { return word.length > 1; });
  }

  function count(text, word) { return text.split(word).length - 1; }

  // Every word has to occur; in a title it counts for ten in the text.
  function worth(section, words) {
    var title = section.title.toLowerCase(), text = section.text.toLowerCase(), sum = 0;
    for (var i = 0; i < words.length; i++) {
      var here = 10 * count(title, words[i]) + Math.min(count(text, words[i]), 9);
      if (here === 0)
        return 0;
      sum += here;
    }
    return sum;
  }

  function excerpt(section, words) {
    var at = Math.max(0, section.text.toLowerCase().indexOf(words[0]) - 80);
    return (at > 0 ? "… " : "") + section.text.substr(at, 240) + " …";
  }

  function add(parent, kind, text) {
    var element = document.createElement(kind);
    element.textContent = text;
    parent.appendChild(element);
    return element;
  }

  function show(query) {
    var list = document.getElementById("mkdocs-search-results");
    list.textContent = "";
    var words = wordsOf(query);
    var found = words.length === 0 ? [] : manualSections
      .map(function (section) { return { section: section, worth: worth(section, words) }; })
      .filter(function (one) { return one.worth > 0; })
      .sort(function (a, b) { return b.worth - a.worth; })
      .slice(0, 50);
    if (found.length === 0)
      add(list, "p", words.length ? "No page has all of these words." : "");
    found.forEach(function (one) {
      var article = add(list, "article", "");
      var link = add(add(article, "h3", ""), "a", one.section.title);
      link.href = base_url + "/" + one.section.location;
      add(article, "p", excerpt(one.section, words));
    });
  }

  var field = document.getElementById("mkdocs-search-query");
  if (!field)
    return;
  var asked = new URLSearchParams(window.location.search).get("q");
  if (asked)
    field.value = asked;
  field.addEventListener("input", function () { show(field.value); });
  show(field.value);
})();
