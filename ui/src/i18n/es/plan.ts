import type { plan as first } from "../pt-BR/plan";

export const plan: typeof first = {
  title: "Clase de dos horas",
  about:
    "Dos veces 50 minutos, cinco grupos. Cada grupo programa su letra; al final, una seña la llama.",
  print: "Imprimir",
  save: "Guardar como archivo",
  saveHelp: "Guarda una página que se abre e imprime en cualquier navegador",
  fileName: "plan-de-clase",
  columns: { minutes: "min", teacher: "Docente", groups: "Grupos", screen: "Pantalla" },
  steps: {
    human: {
      minutes: "0–15",
      teacher: "“¿A qué obedece una aspiradora robot?” Robot humano: solo “avanzar 1”, “girar 90”.",
      groups: "Dan ejemplos; dictan hasta la puerta: girar no avanza.",
      screen: "Ejemplo Aspiradora",
    },
    alphabet: {
      minutes: "15–25",
      teacher: "Alfabeto: A, B, E, L, S, T, vistas de frente.",
      groups: "Copian en parejas.",
      screen: "Letras grandes",
    },
    first: {
      minutes: "25–35",
      teacher: "Paseo inicial y actividad 1.3.",
      groups: "Predicen, ejecutan, comparan.",
      screen: "Tarjeta, piso",
    },
    paper: {
      minutes: "35–50",
      teacher:
        "Da papel y tarjetas recortadas (avanzar, girar, repetir, lápiz, leer gesto, si; el número va a lápiz).",
      groups: "Planean la letra (2.6); uno camina el plan.",
      screen: "Apagada",
    },
    blocks: {
      minutes: "50–70",
      teacher: "Circula: “¿Qué bloque hizo eso?”",
      groups: "Pasan las tarjetas a bloques, ejecutan, cambian de papel.",
      screen: "Bloques y piso",
    },
    decide: {
      minutes: "70–75",
      teacher: "“Primero leer, después decidir.”",
      groups: "Ponen leer gesto y si.",
      screen: "Actividad 3.1",
    },
    show: {
      minutes: "75–92",
      teacher: "Un grupo por vez: seña, robot, el curso lee.",
      groups: "Explican un arreglo (“10° más en el último giro”).",
      screen: "Robot o proyector",
    },
    talk: {
      minutes: "92–100",
      teacher:
        "“¿Se cerró? ¿Es simétrica? ¿Volvió? Lo difícil: ¿ángulo, distancia, orden, momento de la seña?”",
      groups: "Una frase cada uno.",
      screen: "Líneas de la clase",
    },
  },
  robots:
    "Un robot real: 3 min por grupo, cinta de 1 m en el piso, mano en Parar. Ninguno: el proyector es el piso.",
  deaf: {
    title: "Con un alumno sordo",
    points: [
      "Intérprete y pantalla lado a lado; habla una persona por vez.",
      "Señas acordadas antes: robot, girar, repetir, arreglo.",
      "Tarjetas con la mano dibujada.",
      "Lo que dice el robot queda escrito; el pitido también se ve, y ninguna pista es solo sonora.",
      "Enseña el alfabeto si quiere, sin volverse traductor.",
    ],
  },
  projector: {
    title: "Una computadora y proyector",
    points: [
      "Planes en papel.",
      "Un grupo arma, los otros predicen con los dedos (1–4).",
      "Cada 6 min se cambia, y el próximo arregla.",
    ],
  },
  roles:
    "En cada grupo todos actúan: piloto, lector, inspector del piso, señante. Cambian cada diez minutos.",
  open: (activity) => `Abrir ${activity} para el curso`,
  isOpen: (activity) => `${activity} está abierta para el curso`,
  noClass: "Para abrir una actividad desde aquí, cree antes un curso.",
  links: { cards: "Tarjetas para recortar", letters: "Practicar señas", lessons: "Clases" },
  cards: {
    title: "Tarjetas para recortar",
    about: "Bloques de verdad, con espacio para escribir los valores a lápiz.",
    back: "Plan de clase",
    which: "Cuáles",
    lists: {
      lesson: "De la clase de dos horas",
      level1: "Nivel 1",
      level2: "Nivel 2",
      level3: "Nivel 3: todos",
      letters: "Señas A, B, E, L, S, T",
    },
    copies: "De cada una",
    ink: "Color",
    inks: { lines: "Negro sobre blanco", colours: "En colores" },
    sheet: "Tarjetas",
    drawing: "Dibujando las tarjetas…",
    fileName: "tarjetas",
    printHelp:
      "Hoja A4. Si aquí no hay impresora, guarde como archivo y ábralo en un navegador de otra computadora.",
  },
};
