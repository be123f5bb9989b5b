import type { help as first } from "../pt-BR/help";

/** Examples, help about blocks and keys, and the guided first drive. */
export const help: typeof first = {
  examples: {
    title: "Ejemplos",
    hint: "Se abren como copia: ejecútenlos, luego desármenlos y cámbienlos.",
  },
  search: "Buscar en la ayuda",
  nothing: "Nada con esas palabras. Prueben otras.",
  tryIt: "Probar",
  tryItHelp: "Pone el bloque en el programa",
  openExample: "Abrir una copia",
  moreInLevel: "Hay más bloques para esto en otro nivel.",
  tabs: {
    tasks: "¿Qué se puede hacer?",
    blocks: "Bloques",
    keys: "Teclas",
  },
  tasks: {
    drive: "Avanzar y girar",
    draw: "Dibujar en el piso",
    sense: "Sentir lo que hay alrededor",
    decide: "Decidir",
    repeat: "Repetir",
  },
  keys: {
    blocks: "Bloques",
    palette: "Ir a las categorías de bloques",
    program: "Ir al programa",
    arrows: "Moverse entre los bloques",
    enter: "Poner el bloque; cambiar un número",
    move: "Mover el bloque con las flechas",
    remove: "Borrar el bloque",
    copy: "Copiar y pegar",
    escape: "Salir de lo que está abierto",
    tab: "Ir a la siguiente parte de la pantalla",
  },
};
