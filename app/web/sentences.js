// The page's own sentences by language, for the time before the program has loaded and outside it. English is
// complete; sentences missing in another language are shown in English. {0} and {1} are replaced.
const kPageSentences = {
  en: {
    "fetch": "Fetch it",
    "do not fetch": "Do not",
    "asked to fetch": "This page is asked to fetch {0} from {1}. That server then sees that you do so.",
    "too old": "This browser is too old for Moltact: it needs one of 2023 or later.",
    "stopped": "Moltact has stopped: {0}",
    "no WebGL": "This browser offers no WebGL 2, which Moltact draws with. Another browser, or newer graphics drivers, may.",
    "not started": "Moltact could not start: {0}",
    "your code": "Type the code that you were given.",
    "no such code": "{0} is not one of the codes of this study. Look at it again, letter by letter.",
    "begin": "Begin",
  },
  de: {
    "fetch": "Laden",
    "do not fetch": "Nicht laden",
    "asked to fetch": "Diese Seite soll {0} von {1} laden. Jener Server erfährt dann, dass du das tust.",
    "too old": "Dieser Browser ist zu alt für Moltact: nötig ist einer von 2023 oder später.",
    "stopped": "Moltact wurde beendet: {0}",
    "no WebGL": "Dieser Browser bietet kein WebGL 2, mit dem Moltact zeichnet. Ein anderer oder neuere Treiber vielleicht.",
    "not started": "Moltact konnte nicht starten: {0}",
    "your code": "Gib den Code ein, den du bekommen hast.",
    "no such code": "{0} ist keiner der Codes dieser Studie. Sieh ihn noch einmal Zeichen für Zeichen an.",
    "begin": "Beginnen",
  },
  // A draft that no native speaker has read.
  fr: {
    "fetch": "Charger",
    "do not fetch": "Ne pas charger",
    "asked to fetch": "Cette page doit charger {0} depuis {1}. Ce serveur voit alors que tu le fais.",
    "too old": "Ce navigateur est trop ancien pour Moltact : il en faut un de 2023 ou plus récent.",
    "stopped": "Moltact s’est arrêté : {0}",
    "no WebGL": "Ce navigateur n’offre pas WebGL 2, avec lequel Moltact dessine. Un autre navigateur, ou des pilotes plus récents, peut-être.",
    "not started": "Moltact n’a pas pu démarrer : {0}",
    "your code": "Tape le code que tu as reçu.",
    "no such code": "{0} n’est aucun des codes de cette étude. Regarde-le encore une fois, lettre par lettre.",
    "begin": "Commencer",
  },
};

/// The language of the table for a browser's, such as "de-AT"; English where the table has none.
function moltactLanguage(locale, table = kPageSentences) {
  const code = (locale || "").toLowerCase().split("-")[0];
  return Object.hasOwn(table, code) ? code : "en";
}

function moltactSentence(language, key, ...pieces) {
  const text = kPageSentences[language][key] ?? kPageSentences.en[key];
  return text.replace(/\{(\d)\}/g, (_, k) => String(pieces[k]));
}
