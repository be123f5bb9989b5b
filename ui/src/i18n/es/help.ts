import type { help as first } from "../pt-BR/help";

/** Examples, help about blocks and keys, and the guided first drive. */
export const help: typeof first = {
  examples: {
    title: "Ejemplos",
    hint: "Se abren como copia: ejecútenlos, luego desármenlos y cámbienlos.",
  },
  search: "Buscar en la ayuda",
  nothing: "Sin resultados. Prueben otras palabras.",
  tryIt: "Probar",
  tryItHelp: "Pone el bloque en el programa",
  playFilm: "Ver otra vez",
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
  tour: {
    title: "Primer paseo",
    hello: "Este es el robot. ¿Hacemos que el robot avance?",
    move: (block: string, start: string) => `Arrastren “${block}” debajo de “${start}”.`,
    run: (run: string) => `Presionen ${run}.`,
    watch: "Avanza 1 m; el bloque encendido es lo que hace ahora.",
    watchOther: "El bloque encendido es lo que hace ahora.",
    turn: (block: string) =>
      `Ahora arrastren “${block}” debajo de él. ¿Hacia qué lado irá el robot?`,
    again: "Ejecuten y miren: el robot gira, pero no avanza.",
    end: (stop: string) =>
      `${stop} está siempre aquí. Todo queda guardado. ¿Vamos a la primera misión?`,
    other: "También sirve. Ejecuten y vean.",
    go: "Vamos",
    skip: "Saltar",
    show: "Mostrar",
    mission: "Empezar",
    free: "Explorar libremente",
    place: (n: number, all: number) => `Paso ${n} de ${all}`,
  },
};
